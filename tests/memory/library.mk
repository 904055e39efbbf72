# The library that makes allocations fail, for memory.t. Sanitizers have an allocator of their own. The Makefile
# includes this.
FAIL_MALLOC := $(if $(SANITIZE),,$(B)/tests/memory/fail_malloc.so)
$(B)/tests/memory/fail_malloc.so: tests/memory/fail_malloc.c $(B)/flags
	@mkdir -p $(@D)
	$(call say,link $@)$(CC) -std=c11 $(BASE) $(WARN) $(CFLAGS) -fPIC -shared -o $@ $<
