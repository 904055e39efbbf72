/* Rules on options that need others to have an effect. Those on techniques follow from what the techniques say of
 * themselves. */
#ifndef RENDER_MODE_RULES_H
#define RENDER_MODE_RULES_H

#include "render-gl/technique/list.h"

/* Returns the rules of the command, ended by one without options. */
const struct cmd_rule *rules_make(void);

/* Returns whether feature lines are drawn by default over the pictures of a technique. */
bool rules_have_lines(const struct technique *drawn);

#endif
