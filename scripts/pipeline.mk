# Campaigns as chains of make targets: mesh, mix, dem and wear of every cycle, then the report.
#   make -f scripts/pipeline.mk CASE=cases/pilot_mill/case.toml            the whole campaign
#   make -f scripts/pipeline.mk CASES="a.toml b.toml" -j 2                 several side by side
#   make -f scripts/pipeline.mk CASE=... CYCLE=3 dem                       one stage and what it needs
# A stage is published by one rename, so what a killed make leaves half-made never counts as done.
MILLWEAR ?= build/release/millwear
RUNS ?= runs
CASES ?= $(CASE)
CYCLE ?= 0
OPTIONS ?= --quiet

ifeq ($(strip $(CASES)),)
$(error name a case: make -f scripts/pipeline.mk CASE=cases/pilot_mill/case.toml)
endif
this := $(firstword $(MAKEFILE_LIST))
name = $(shell sed -n 's/^name *= *"\([^"]*\)".*/\1/p' $(1) | head -n 1)
.PHONY: all mesh mix dem wear report $(CASES:%=campaign~%)
all: $(CASES:%=campaign~%)

# One campaign: cycle after cycle until the liner is worn out. How many there are, its wear decides.
$(CASES:%=campaign~%): campaign~%:
	@cycle=0; while :; do \
	  $(MAKE) --no-print-directory -f $(this) CASE=$* CASES=$* CYCLE=$$cycle wear || exit; \
	  case $$($(MILLWEAR) status $* --out $(RUNS)/$(call name,$*) --json) in \
	    *'"next": ""'*) break ;; esac; \
	  cycle=$$((cycle + 1)); done
	@$(MAKE) --no-print-directory -f $(this) CASE=$* CASES=$* CYCLE=$$(ls -d $(RUNS)/$(call name,$*)/cycle_* | wc -l | awk '{ print $$1 - 1 }') report

run := $(RUNS)/$(call name,$(firstword $(CASES)))
three = $(shell printf %03d $(1))
here := $(run)/cycle_$(call three,$(CYCLE))
before := $(if $(filter-out 0,$(CYCLE)),$(run)/cycle_$(call three,$(shell expr $(CYCLE) - 1)))
step = $(MILLWEAR) run $(firstword $(CASES)) --out $(run) $(OPTIONS) --until $(CYCLE):

mesh: $(here)/mesh/mesh.json
mix: $(here)/mix/charge.restart
dem: $(here)/dem/load.h5
wear: $(here)/wear/steps.json
report: $(run)/report.html

$(here)/mesh/mesh.json: $(if $(before),$(before)/wear/steps.json,$(firstword $(CASES)))
	@$(step)mesh >/dev/null && touch $@
$(here)/mix/charge.restart: $(here)/mesh/mesh.json
	@$(step)mix >/dev/null && touch $@
$(here)/dem/load.h5: $(here)/mesh/mesh.json $(if $(before),$(before)/dem/load.h5,$(here)/mix/charge.restart)
	@$(step)dem >/dev/null && touch $@
$(here)/wear/steps.json: $(here)/dem/load.h5
	@$(step)wear >/dev/null && touch $@
$(run)/report.html: $(here)/wear/steps.json
	@$(MILLWEAR) report $(firstword $(CASES)) --out $(run) && touch $@
