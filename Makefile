# SPDX-License-Identifier: MIT OR Apache-2.0
# `make help` lists the targets.

PYTHON ?= python3.11
VENV := .venv
BIN := $(VENV)/bin
WHEEL_SOURCES := Cargo.toml Cargo.lock pyproject.toml guides/registry.json $(wildcard guides/mini/*) \
	$(shell find src python -name '*.rs' -o -name '*.wgsl' -o -name '*.py' -o -name '*.pyi')
ADDON_SOURCES := scripts/build_extension.py $(shell find addon -type f -not -name '*.pyc')

.PHONY: help tools setup test demo pictures bench extension release repository site guide lint format clean

help: ## list the targets
	@grep -hE '^[a-z]+:.*## ' $(MAKEFILE_LIST) | sed -E 's/:.*## /\t/' | expand -t 12

tools:
	@command -v c++ >/dev/null || { echo "Boxmorph needs a C++ compiler: install g++ or clang." >&2; exit 1; }
	@command -v $(PYTHON) >/dev/null || { echo "Boxmorph needs Python 3.11: install it, or name it with PYTHON=..." >&2; exit 1; }
	@command -v cargo >/dev/null || { echo "Boxmorph needs Rust 1.92 or later: install cargo (https://rustup.rs)." >&2; exit 1; }

setup: tools $(VENV)/.wheel ## make .venv with bpy and the freshly built wheel

$(VENV)/.requirements: requirements/build.txt
	$(PYTHON) -m venv $(VENV)
	$(BIN)/pip install --quiet --disable-pip-version-check -r requirements/build.txt
	@touch $@

$(VENV)/.wheel: $(VENV)/.requirements $(WHEEL_SOURCES) scripts/fetch_onnxruntime.py
	$(BIN)/python scripts/fetch_onnxruntime.py
	rm -f dist/*.whl
	$(BIN)/maturin build --release --quiet --out dist
	$(BIN)/pip install --quiet --disable-pip-version-check --force-reinstall --no-deps dist/*.whl
	@touch $@

extension: setup $(VENV)/.extension ## build the installable zip in dist/

$(VENV)/.extension: $(VENV)/.wheel $(ADDON_SOURCES)
	$(BIN)/python scripts/build_extension.py
	@touch $@

release: $(VENV)/.requirements ## build the zip for every Linux from glibc 2.28 on, with zig, in dist/release/
	$(BIN)/pip install --quiet --disable-pip-version-check ziglang==0.17.1
	$(BIN)/python scripts/fetch_onnxruntime.py
	rm -rf dist/release
	PATH="$(CURDIR)/$(BIN):$$PATH" $(BIN)/maturin build --release --zig --compatibility manylinux_2_28 --quiet --target-dir target/zig --out dist/release
	$(BIN)/python scripts/build_extension.py --wheel dist/release/*.whl --output-dir dist/release

repository: release ## put the release into dist/repository/, from which Blender installs and updates
	$(BIN)/python scripts/build_repository.py dist/release/*.zip

$(VENV)/.site-requirements: $(VENV)/.requirements requirements/site.txt
	$(BIN)/pip install --quiet --disable-pip-version-check -r requirements/site.txt
	@touch $@

site: $(VENV)/.site-requirements ## make a site of the documents in dist/site/, to be opened or served
	rm -rf dist/site
	$(BIN)/python -m sphinx --fail-on-warning --keep-going --quiet -c docs/site -d build/doctrees . dist/site

$(VENV)/.test-requirements: $(VENV)/.requirements requirements/test.txt
	$(BIN)/pip install --quiet --disable-pip-version-check -r requirements/test.txt
	@touch $@

test: extension $(VENV)/.test-requirements $(VENV)/.site-requirements ## run all tests, ending in their counts
	$(BIN)/python scripts/run_tests.py

demo: extension ## deform the example objects, results in demo/out/
	$(BIN)/python demo/run.py

pictures: extension ## deform odd meshes of every kind, pictures of docs/meshes.md in docs/images/meshes/
	$(BIN)/python demo/meshes.py

# The peers of the bench, apart from .venv as they take gigabytes; where they cannot be installed it goes on without.
benches/.venv/.requirements: requirements/bench.txt
	$(PYTHON) -m venv benches/.venv
	benches/.venv/bin/pip install --quiet --disable-pip-version-check -r requirements/bench.txt
	@touch $@

benches/.venv/.wheel: benches/.venv/.requirements $(VENV)/.wheel
	benches/.venv/bin/pip install --quiet --disable-pip-version-check --force-reinstall --no-deps dist/*.whl
	@touch $@

bench: setup $(VENV)/.test-requirements ## measure field, rendering, encoding and search beside their peers, in one run
	-@$(MAKE) --no-print-directory benches/.venv/.wheel
	$(BIN)/python benches/bench.py

guide: setup ## train the embedded guide again, from nothing (one to two hours on two cores)
	test -d training/.venv || $(PYTHON) -m venv training/.venv
	training/.venv/bin/pip install --quiet -r training/requirements.txt dist/*.whl
	training/.venv/bin/python training/train.py

lint: setup $(VENV)/.test-requirements ## check formatting, clippy, ruff and, where installed, cargo deny
	cargo fmt --check
	cargo clippy --release --all-targets --features python -- -D warnings
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	@if command -v cargo-deny >/dev/null; then cargo deny check; else echo "cargo-deny is not installed: licences and advisories are not checked"; fi

format: $(VENV)/.test-requirements ## format Rust and Python
	cargo fmt
	$(BIN)/ruff check --fix --quiet .
	$(BIN)/ruff format --quiet .

clean: ## remove everything that was built
	rm -rf target dist $(VENV) build demo/out tests/artifacts python/boxmorph/onnxruntime
