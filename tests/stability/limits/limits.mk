# The table of limits (tests/stability/limits.t) and its page, docs/limits.md. The Makefile includes this.
LIMITS := $(patsubst tests/%.c,$(B)/tests/%,$(wildcard tests/stability/limits/programs/*.c))
limits: all $(LIMITS)
	PATH=$(abspath $(B))/bin:$(abspath $(B))/tests/stability/limits/programs:$$PATH sh tests/stability/limits/draw.sh
check: $(LIMITS)
.PHONY: limits
