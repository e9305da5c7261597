PYTHON ?= python3
REQUIRE ?=
export REQUIRE

VENV := .venv
BIN := $(VENV)/bin
INSTALLED := $(VENV)/.installed
SUDO := $(shell [ "$$(id -u)" = 0 ] || echo sudo)
SYSTEM_PACKAGES := chromium ffmpeg gcc-avr avr-libc simavr libsimavr-dev libelf-dev \
	libsdl2-2.0-0 umockdev gir1.2-umockdev-1.0 python3-gi

.DEFAULT_GOAL := help
.PHONY: help demo test quick bench bench-arm bench-stick bench-view reference front lock system-packages

help:  ## Say what can be made
	@grep -hE '^[a-z-]+:.*## ' $(MAKEFILE_LIST) | sed -E 's/^([a-z-]+):[^#]*## /\1\t/' | expand -t 18

demo: $(INSTALLED)  ## Install, then run the published study with virtual participants
	$(BIN)/omnistudy demo

test: $(INSTALLED)  ## Check everything; REQUIRE=all treats a skip as a failure
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports --no-cache
	$(BIN)/pytest -n 2

quick: $(INSTALLED)  ## Check in under two minutes: leaves out slow tests
	$(BIN)/ruff check .
	$(BIN)/mypy
	$(BIN)/lint-imports --no-cache
	$(BIN)/pytest -n 2 -m "not slow"

bench: $(INSTALLED)  ## Measure speed and memory, printed as JSON, then the stick as bench-stick does (on stderr)
	@$(BIN)/python benchmarks/run.py
	@$(BIN)/python benchmarks/stick.py >&2

bench-arm: $(INSTALLED)  ## Measure the arm's controllers: success over random tasks, doors, a step's time
	@$(BIN)/python benchmarks/arm.py

bench-view: $(INSTALLED)  ## Measure the replay page: how soon it opens, how evenly it plays; prints JSON
	@$(BIN)/python benchmarks/replay_page.py

bench-stick: $(INSTALLED)  ## Measure the stick: firmware's latency and cycles, largest stiffness, live jitter, page
	@$(BIN)/python benchmarks/stick.py

reference: $(INSTALLED)  ## Renew docs/reference from the commands' help and the models
	$(BIN)/python docs/make_reference.py
	$(BIN)/python docs/make_protocol_reference.py

front:  ## Build the browser's side again with Node.js 20 (users need none)
	cd front && npm ci && npm run check && npm run build

lock: $(INSTALLED)  ## Renew requirements.lock on purpose
	$(BIN)/pip install --quiet uv
	$(BIN)/uv pip compile --quiet --universal --python-version 3.11 --generate-hashes --upgrade \
		--extra dev --no-header --no-annotate --no-emit-index-url --no-emit-find-links \
		--output-file requirements.lock pyproject.toml

system-packages:  ## Install what the tests need from Debian (apt-get; asks for sudo)
	@echo "installing from Debian: $(SYSTEM_PACKAGES)"
	$(SUDO) apt-get update
	$(SUDO) env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends $(SYSTEM_PACKAGES)

$(INSTALLED): requirements.lock pyproject.toml
	@command -v $(PYTHON) > /dev/null || { echo "error: there is no $(PYTHON) here: name a Python of 3.11 or later with make PYTHON=/path/to/python"; exit 1; }
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { echo "error: $(PYTHON) is $$($(PYTHON) --version), omnistudy needs 3.11 or later: name one with make PYTHON=python3.11"; exit 1; }
	@$(PYTHON) -c 'import sys, platform as p; sys.exit((sys.version_info[:2], sys.platform, p.machine()) != ((3, 11), "linux", "x86_64"))' || echo "PyBullet has no ready wheel for this Python and machine: it is compiled now with g++, which takes some minutes without a word"
	$(PYTHON) -m venv $(VENV)
	$(BIN)/pip install --quiet --require-hashes --requirement requirements.lock
	$(BIN)/pip install --quiet --no-deps --no-build-isolation --editable .
	@touch $@
