# Programs called test_*_steps.c count the steps of these folders (support/steps.h): their objects are made again, so
# that each block of code calls the program's counter. The Makefile includes this.
COUNTED_SRC := $(wildcard $(patsubst %,libhatch/%/*.c,base mesh surface io/mesh))
COUNTED := $(patsubst %,$(B)/obj/counted/%.o,$(COUNTED_SRC))
$(B)/obj/counted/%.c.o: %.c $(B)/flags
	@mkdir -p $(@D)
	$(call say,cc $<)$(CC) -std=c11 $(BASE) $(CFLAGS) $(CPPFLAGS) -fsanitize-coverage=trace-pc -c -o $@ $<
$(filter %_steps,$(TESTS)): $(COUNTED)
