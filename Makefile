# millwear from the shell. `make help` says what there is.
.PHONY: all build demo study seed-spacing seed seed-check validate test unit slurm-test sanitize coverage check-style bench install clean help

PROGRAM := build/release/millwear
DEMO_CASE := cases/pilot_mill/case.toml
DEMO_RUN := runs/pilot_mill
SEED := seed_mill_8m_desktop
SEEDS := 1
SPACING := seed_spacing_study
PREFIX := /usr/local
CTEST := ctest --preset ci --no-tests=error

all: build

build: ## Install what is missing and build build/release/millwear
	@scripts/install_packages.sh run
	@cmake --preset release -DMILLWEAR_TESTS=OFF >build-release.log 2>&1 || { cat build-release.log; exit 1; }
	@rm -f build-release.log
	@cmake --build --preset release

demo: build ## Simulate the pilot mill's liner from new to worn out, and print the report's path
	@$(PROGRAM) run $(DEMO_CASE) --out $(DEMO_RUN)

study: build ## Simulate the pilot mill with six spacings of its lifters and compare them; resumes
	@$(PROGRAM) study cases/spacing_study/study.toml --out runs/spacing_study

seed-spacing: build ## Compare five spacings of the 8 m mill's lifters, from kept results
	@mkdir -p runs && rm -rf runs/$(SPACING)_kept && cp -r cases/$(SPACING)/reference runs/$(SPACING)_kept
	@$(PROGRAM) study cases/$(SPACING)/study.toml --out runs/$(SPACING)_kept

seed: build ## Simulate the 8 m mill's liner from new to worn out, once for each of SEEDS="1 2 3"; resumes
	@for seed in $(SEEDS); do \
	  $(PROGRAM) run cases/$(SEED)/case.toml --seed $$seed --out runs/$(SEED)/seed_$$seed || exit; done

seed-check: build ## Compare the 8 m mill's kept campaigns with its published gauge readings
	@$(PROGRAM) compare cases/$(SEED)/case.toml --calibrate-until 5112 \
	  $(patsubst %,--out %,$(wildcard cases/$(SEED)/reference/seed_*))

validate: build ## Simulate the published experiments of cases/validation; resumes, and prints a table
	@scripts/install_packages.sh test
	@cmake --preset ci >/dev/null
	@cmake --build --preset ci --target validation_table
	@scripts/validate.sh runs/validation

test: ## Install what is missing, build with warnings as errors and run every test
	@scripts/install_packages.sh test
	@scripts/check_includes.sh
	@scripts/check_format.sh
	@cmake --preset ci >/dev/null
	@cmake --build --preset ci
	@$(CTEST)

unit: ## Only the tests that need neither LIGGGHTS nor a browser
	@cmake --preset ci >/dev/null
	@cmake --build --preset ci
	@$(CTEST) -LE 'needs_liggghts|needs_chromium'

slurm-test: ## Submit a study to a Slurm of one node, started on this machine; as root, five minutes
	@scripts/install_packages.sh test
	@cmake --preset ci >/dev/null
	@cmake --build --preset ci
	@$(CTEST) -L slurm

sanitize: ## Unit tests under address and undefined-behaviour sanitizers; no two types of one name
	@scripts/install_packages.sh test
	@cmake --preset sanitize >/dev/null
	@cmake --build --preset sanitize --target one_definition unit_tests
	@scripts/run_sanitized_tests.sh build/sanitize/tests/unit

coverage: ## Predicted errors against the scatter of kept campaigns of the pilot mill and the 8 m mill
	@cmake --preset ci >/dev/null
	@cmake --build --preset ci --target coverage_table coverage_test
	@build/ci/tests/coverage/coverage_test --gtest_brief=1
	@for mill in pilot_mill $(SEED); do \
	  echo "$$mill"; build/ci/tests/coverage/coverage_table cases/$$mill/coverage || exit; done

bench: ## Time the contact reader, a geometry step, publishing and a study of 10,000 points
	@cmake --preset release -DMILLWEAR_TESTS=ON >/dev/null
	@cmake --build build/release --target bench_contact_reader bench_wear bench_publishing bench_study
	@build/release/liggghts_inputs/bench/bench_contact_reader
	@build/release/wear/bench/bench_wear
	@build/release/orchestrator/bench_publishing
	@build/release/orchestrator/bench_study cases/pilot_mill/case.toml

install: build ## Install programs and library; PREFIX says where
	@cmake --install build/release --prefix $(PREFIX)

clean: ## Remove what was built; runs/ stays
	rm -rf build

help:
	@grep -hE '^[a-z-]+:.*## ' $(MAKEFILE_LIST) | sed 's/:.*## /\t/' | expand -t 14
