# Programs named test_*_steps.c count steps in these folders (support/steps.h): their objects are compiled again with a
# call of the program's counter in each basic block. The Makefile includes this.
COUNTED_SRC := $(wildcard $(patsubst %,libhatch/%/*.c,base mesh mesh/nearest surface io/mesh lapped seed solid measure/coarse))
COUNTED := $(patsubst %,$(B)/obj/counted/%.o,$(COUNTED_SRC))
$(B)/obj/counted/%.c.o: %.c $(B)/flags
	@mkdir -p $(@D)
	$(call say,cc $<)$(CC) -std=c11 $(BASE) $(CFLAGS) $(CPPFLAGS) -fsanitize-coverage=trace-pc -c -o $@ $<
$(filter %_steps,$(TESTS)): $(COUNTED)
