# The one way in: `make` lists what there is. Everything installs what it needs (scripts/setup.sh).

MAKEFLAGS += --no-print-directory
# wasm-opt, which Trunk looks for on the path, is a package of npm.
export PATH := $(CURDIR)/.tools/bin:$(CURDIR)/node_modules/.bin:$(PATH)
export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER := wasm-bindgen-test-runner
export WASM_BINDGEN_TEST_TIMEOUT ?= 120

WASM := --target wasm32-unknown-unknown
# Both at once, for then the package's module is built beside the tests in wasm and costs no build of its own.
WEB := $(WASM) --features web,package

.PHONY: help
help: ## this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "make %-12s %s\n", $$1, $$2 }' Makefile

.PHONY: run
run: dist ## build the page and serve it on localhost
	@node scripts/serve.mjs dist

.PHONY: check
check: ## the inner loop: format, lints, native tests
	@scripts/setup.sh lints target editor
	@scripts/stages.sh fmt lint lint-web test-native

.PHONY: test
# What is compiled once needs no traces for the next time: an eighth less work.
test: export CARGO_INCREMENTAL := 0
test: ## every test of every kind, with the time of each stage
	@scripts/stages.sh setup 'dist&' fmt lint lint-web wait sizes test-native test-wasm test-package test-e2e

.PHONY: clauses
clauses: ## the clauses of the four papers, each with the verdict of its test
	@cargo test --locked --quiet --test it -- --exact papers::table_of_clauses_holds --nocapture

.PHONY: bench
bench: dist ## benchmarks, native, in wasm and of the page; each ends in lines `summary: …`
	@scripts/setup.sh browser bench
	cargo bench --locked --bench interp --bench parse --bench plan --bench run --bench polygon
	node scripts/both.mjs
	node benches/page.mjs
	node benches/load.mjs

# How long each fuzz target runs.
FUZZ_SECONDS ?= 900

.PHONY: fuzz
fuzz: ## parser and interpreter on bytes that try to break them, 15 minutes each (FUZZ_SECONDS=…)
	@scripts/setup.sh fuzz
	@mkdir -p fuzz/corpus/parser fuzz/corpus/interpreter
	cargo fuzz run -s none parser fuzz/corpus/parser $(FUZZ_SEEDS) -- $(FUZZ_FLAGS)
	cargo fuzz run -s none interpreter fuzz/corpus/interpreter $(FUZZ_SEEDS) -- $(FUZZ_FLAGS)

FUZZ_SEEDS = $(wildcard tests/data/programs/*/ok tests/data/programs/*/bad)
FUZZ_FLAGS = -max_total_time=$(FUZZ_SECONDS) -max_len=4096 -timeout=20 -dict=fuzz/nc.dict -print_final_stats=1

.PHONY: dist
dist: ## the static site in dist/
	@scripts/setup.sh target tools node
	@echo 'dist: sources of the packages'
	@cargo fetch --locked --quiet
	@echo 'dist: building the page (some minutes the first time)'
	trunk build --release

.PHONY: package
package: ## the npm package of the core in target/npm, ready for `npm pack`
	@scripts/setup.sh target tools node
	cargo build --locked $(WASM) --features package --profile web --bin package
	node scripts/package.mjs target/wasm32-unknown-unknown/web/package.wasm target/npm --optimise

.PHONY: pictures
pictures: dist ## pictures of every view in its sizes and themes, compared with the accepted ones (VIEW=… for some)
	@scripts/setup.sh node browser
	node tests/e2e/pictures.mjs $(VIEW)

.PHONY: accept-pictures
accept-pictures: dist ## the same, accepted: looked at, they are what the page should be
	@scripts/setup.sh node browser
	node tests/e2e/pictures.mjs --accept $(VIEW)

.PHONY: format
format: ## format the sources
	@scripts/setup.sh lints
	cargo fmt

.PHONY: clean
clean: ## remove what was built (not .tools)
	cargo clean
	rm -rf dist node_modules benches/node_modules

# The stages of `make test`, each also on its own; what they need is installed by `make setup`.

.PHONY: setup
setup: ## install everything that any target needs
	@scripts/setup.sh lints target tools node browser editor

.PHONY: fmt
fmt:
	cargo fmt --check

.PHONY: lint
lint:
	cargo clippy --locked --all-targets -- -D warnings
	@# The fuzz targets are a package of their own: its lockfile has to know the same dependencies.
	cargo update --locked --workspace --quiet --manifest-path fuzz/Cargo.toml

.PHONY: lint-web
lint-web:
	cargo clippy --locked $(WEB) --profile test --lib --bin app --bin worker --bin package --test parity -- -D warnings

.PHONY: test-native
test-native: ## native tests
	cargo test --locked --quiet

.PHONY: test-wasm
test-wasm: ## in wasm: components in headless Chromium, and the goldens again under Node
	cargo test --locked $(WEB) --lib --test parity

.PHONY: test-package
test-package: ## the npm package, not optimised: goldens and types in Node, its example page in Chromium
	cargo test --locked --quiet $(WEB) --lib --test parity --no-run
	node scripts/package.mjs target/wasm32-unknown-unknown/debug/package.wasm target/npm-test
	node --test --test-concurrency=2 --test-reporter=spec $(wildcard tests/package/*.test.mjs)

.PHONY: sizes
sizes: ## what the browser loads (of the dist/ that is there), against its limits
	node scripts/sizes.mjs dist

.PHONY: test-e2e
test-e2e: ## a person's paths through the dist/ that is there
	node --test --test-concurrency=2 --test-reporter=spec $(PATHS)

# A person's paths; the one of WebKit has a driver of its own.
PATHS = $(filter-out %/webkit.test.mjs,$(wildcard tests/e2e/*.test.mjs))

.PHONY: test-browsers
test-browsers: ## the same paths in Firefox ESR and a short one in WebKit, of the dist/ that is there
	@scripts/setup.sh node other_browsers
	BROWSER=firefox node --test --test-concurrency=1 --test-reporter=spec $(PATHS)
	node --test --test-reporter=spec tests/e2e/webkit.test.mjs
