-- Drives macroline as Neovim's client does, and prints one line of JSON: what an engineer would see.
-- Environment: MACROLINE is the program, FILE the program to open.
local function wait(what, done)
  if not vim.wait(20000, done, 20) then error('no ' .. what) end
end

local function session()
  vim.cmd('edit ' .. vim.fn.fnameescape(vim.env.FILE))
  local buffer = vim.api.nvim_get_current_buf()
  local id = vim.lsp.start_client({ name = 'macroline', cmd = { vim.env.MACROLINE, 'lsp', '--control', 'mitsubishi-e60' } })
  vim.lsp.buf_attach_client(buffer, id)

  local function ask(method, line, character, more)
    local params = { textDocument = vim.lsp.util.make_text_document_params(buffer), position = { line = line, character = character } }
    local answers = vim.lsp.buf_request_sync(buffer, method, vim.tbl_extend('force', params, more or {}), 20000)
    return answers and answers[id] and answers[id].result
  end

  wait('diagnostics', function() return #vim.diagnostic.get(buffer) > 0 end)
  local seen = { before = {} }
  for _, found in ipairs(vim.diagnostic.get(buffer, { severity = vim.diagnostic.severity.ERROR })) do
    table.insert(seen.before, { line = found.lnum, code = tostring(found.code), source = found.source })
  end

  seen.hover = ask('textDocument/hover', 2, 1).contents.value
  seen.completion = #vim.lsp.util.extract_completion_items(ask('textDocument/completion', 2, 1))
  seen.definition = ask('textDocument/definition', 4, 5).range.start.line
  seen.references = #ask('textDocument/references', 1, 2, { context = { includeDeclaration = true } })
  seen.outline = ask('textDocument/documentSymbol', 0, 0)[1].name

  local range = { start = { line = 3, character = 0 }, ['end'] = { line = 3, character = 20 } }
  local actions = ask('textDocument/codeAction', 3, 0, { range = range, context = { diagnostics = {}, only = { 'quickfix' } } })
  vim.lsp.util.apply_workspace_edit(actions[1].edit, 'utf-16')
  wait('diagnostics of the mended program', function()
    return #vim.diagnostic.get(buffer, { severity = vim.diagnostic.severity.ERROR }) == 0
  end)
  seen.mended = vim.api.nvim_buf_get_lines(buffer, 3, 4, false)[1]

  vim.lsp.stop_client(id)
  wait('end of the server', function() return vim.lsp.client_is_stopped(id) end)
  io.stdout:write(vim.json and vim.json.encode(seen) or vim.fn.json_encode(seen))
end

-- A failure ends Neovim too: it would wait for a key.
local done, why = pcall(session)
if done then
  vim.cmd('qall!')
else
  io.stderr:write(tostring(why))
  vim.cmd('cquit')
end
