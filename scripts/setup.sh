#!/usr/bin/env bash
# Installs the missing tools and packages: `scripts/setup.sh [lints] [target] [tools] [node] [browser] [editor] [other_browsers] [bench] [fuzz]`.
#
# Each version is in one place, where the tool that needs it reads it: Trunk's in Trunk.toml, wasm-bindgen's in Cargo.lock
# (Trunk and the test runner refuse any other), the npm packages' in package-lock.json (those of the benches in benches/). Only the version of cargo-fuzz is here.
set -euo pipefail
cd "$(dirname "$0")/.."

say() { printf '%s\n' "set-up: $*" >&2; }
fail() {
  say "$*"
  exit 1
}

# Cargo.lock is the truth for the library, so it is the truth for the command line tool too.
wasm_bindgen_version() { awk '/^name = "wasm-bindgen"$/ { getline; gsub(/[^0-9.]/, ""); print }' Cargo.lock; }
trunk_version() { sed -nE 's/^trunk-version *= *"=?([0-9.]+)"/\1/p' Trunk.toml; }

# The tools run for seconds and take minutes to build: without link-time optimisation, optimisation and debug
# information the build takes a third of the time.
export CARGO_PROFILE_RELEASE_LTO=off CARGO_PROFILE_RELEASE_OPT_LEVEL=0 CARGO_PROFILE_RELEASE_CODEGEN_UNITS=256
export CARGO_PROFILE_RELEASE_DEBUG=false CARGO_PROFILE_RELEASE_STRIP=none

# tool CRATE VERSION FLAGS TOOL …: puts the tools of a crate into .tools/bin. Where the right version is installed already, by a link;
# the first tool is asked for its version. FLAGS are for cargo install.
tool() {
  local crate=$1 version=$2 flags=$3 dir first
  shift 3
  first=$1
  [ -n "$version" ] || fail "no version found for $crate"
  for dir in .tools/bin "$(dirname "$(command -v "$first" || echo .)")" "${CARGO_HOME:-$HOME/.cargo}/bin"; do
    [ "$("$dir/$first" --version 2>/dev/null | awk '{ print $2 }')" = "$version" ] || continue
    for name in "$@"; do [ -x "$dir/$name" ] || continue 2; done
    [ "$dir" -ef .tools/bin ] && return
    mkdir -p .tools/bin
    for name in "$@"; do ln -sf "$dir/$name" .tools/bin/; done
    return
  done
  say "building $crate $version into .tools (once, some minutes)"
  # shellcheck disable=SC2086
  cargo install "$crate" --version "$version" --locked --force --root .tools $flags
}

lints() {
  cargo fmt --version >/dev/null 2>&1 && cargo clippy --version >/dev/null 2>&1 && return
  command -v rustup >/dev/null || fail "cargo fmt or cargo clippy is missing, and there is no rustup to add them"
  say "rustup: rustfmt and clippy"
  rustup component add rustfmt clippy
}

target() {
  [ -d "$(rustc --print sysroot)/lib/rustlib/wasm32-unknown-unknown" ] && return
  command -v rustup >/dev/null || fail "the Rust target wasm32-unknown-unknown is missing, and there is no rustup to add it"
  say "rustup: target wasm32-unknown-unknown"
  rustup target add wasm32-unknown-unknown
}

tools() {
  # Neither its check for updates nor OpenSSL.
  tool trunk "$(trunk_version)" '--no-default-features --features rustls' trunk
  tool wasm-bindgen-cli "$(wasm_bindgen_version)" '' wasm-bindgen wasm-bindgen-test-runner
}

# npm_packages FOLDER: the packages of its package-lock.json.
npm_packages() {
  command -v npm >/dev/null || fail "Node 20 or newer with npm is missing"
  # npm writes this file last, so it is the time of the last complete installation.
  [ "$1/node_modules/.package-lock.json" -nt "$1/package-lock.json" ] && return
  say "npm: packages of $1/package-lock.json"
  npm ci --no-audit --no-fund --prefix "$1"
  touch "$1/node_modules/.package-lock.json"
}

node() { npm_packages .; }

# Lighthouse is large, and only the benches need it.
bench() { npm_packages benches; }

# libFuzzer is C++.
fuzz() {
  packages c++:g++
  tool cargo-fuzz 0.13.2 '' cargo-fuzz
}

# The fonts are for the screenshots and measures of Chinese text, which would be empty boxes without.
browser() { packages chromium:chromium chromedriver:chromium-driver fc-list:fontconfig cjk:fonts-noto-cjk; }

# A client for the language server.
editor() { packages nvim:neovim; }

# WebKitGTK needs a screen.
other_browsers() { packages firefox-esr:firefox-esr WebKitWebDriver:webkit2gtk-driver Xvfb:xvfb; }

# packages WHAT:PACKAGE …: installs the packages whose command (or font) is missing, all in one go.
packages() {
  local pair missing=()
  for pair in "$@"; do
    case ${pair%%:*} in
      cjk) [ -n "$(fc-list :lang=zh-cn 2>/dev/null | head -n 1)" ] ;;
      *) command -v "${pair%%:*}" >/dev/null ;;
    esac || missing+=("${pair##*:}")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  local root=()
  [ "$(id -u)" = 0 ] || root=(sudo -n)
  if ! command -v apt-get >/dev/null || ! "${root[@]}" true 2>/dev/null; then
    fail "these packages are missing and cannot be installed from here: ${missing[*]} (Debian names)"
  fi
  say "apt: ${missing[*]}"
  "${root[@]}" apt-get update -q
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"
}

command -v cargo >/dev/null || fail "Rust is missing: https://rustup.rs"
packages cc:gcc cc:libc6-dev
for part in "$@"; do
  say "$part"
  "$part"
done
