/* Parameters: options whose values may change from frame to frame, by --animate or by keys in the window. Names, units
 * and ranges are those of the options. */
#ifndef RENDER_MODE_PARAMS_H
#define RENDER_MODE_PARAMS_H

#include "render-gl/mode/options.h"

/* Supplies the parameter at an index, from 0. Returns false beyond the last one. */
bool params_at(uint32_t index, struct param *param);

/* Returns the number of values of a parameter: 2 for pairs, else 1. */
uint32_t params_count(const struct param *param);

/* Returns whether a parameter influences the pictures of a technique.
 *   lines  feature lines are drawn */
bool params_are_used(const struct param *param, const struct technique *technique, bool lines);

/* Get and set the values of a parameter, in the option's unit; values has 2 entries, of which params_count are used.
 * params_set returns whether a value has changed. */
void params_get(const struct param *param, double values[2]);
bool params_set(const struct param *param, const double values[2]);

/* Parses the PARAM=FROM..TO texts of --animate into options->changes, sets those options to FROM, and chooses the view
 * (options_read_view). Exits with a message on wrong usage: also where such an option is refused when it is given. */
void params_read(struct options *options);

/* Returns whether --animate changes a value: FROM and TO are not all the same. */
bool params_differ(const struct options *options);

/* Sets the parameters of --animate to their values at a time.
 *   share  the time, 0 (first frame) .. 1 (last frame)
 * Returns what has changed, as bits 1 << enum param_subject. */
uint32_t params_move(const struct options *options, double share);

/* Returns the share of a motion that runs from 0 to 1, back to 0, and so on.
 *   whole_s  from 0 to 1 */
double params_swing(double time_s, double whole_s);

#endif
