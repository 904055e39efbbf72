/* Opens shared objects while a command runs. */
#ifndef HATCH_BASE_LOAD_H
#define HATCH_BASE_LOAD_H

#include "base/status.h"

/* Opens a shared object and those that it needs; binds all symbols at once and keeps them local.
 *   name    a path, or a name to look for where the system keeps libraries
 *   object  out: for dlsym and dlclose
 * HATCH_LIMIT when memory does not suffice, HATCH_IO when it is missing, damaged or cannot be mapped; the sentence is
 * the system's. */
enum hatch_status hatch_load(const char *name, void **object, struct hatch_err *err) HATCH_MUST_USE;

#endif
