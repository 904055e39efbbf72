/* Private to the curvature: what is known of a point from the fits that serve it. */
#ifndef HATCH_TOPO_CURVATURE_PLACE_H
#define HATCH_TOPO_CURVATURE_PLACE_H

#include <stdbool.h>

#include "curvature/bend.h"

/* Sums over the fits, weighed; and the least expected error, of all levels and of this one. */
struct hatch_place {
    struct hatch_bend bend;
    struct hatch_bend_variance variance;
    double weight, radius, least, now;
    bool open; /* larger supports may still help */
};

static inline double hatch_bend_variance_sum(const struct hatch_bend_variance *variance)
{
    return variance->across + variance->mean;
}

/* What a fit of this expected error weighs. */
double hatch_place_weight(double error);

/* Adds what a fit says. side: -1 where the point's outside is not the fit's. */
void hatch_place_add(struct hatch_place *place, double weight, double side, const struct hatch_bend *bend,
                     const struct hatch_bend_variance *variance, double radius);

/* The weighed means. false when no fit has served the point. */
bool hatch_place_mean(const struct hatch_place *place, struct hatch_bend *bend, struct hatch_bend_variance *variance);

/* Whether the direction is known to this many radians. */
bool hatch_place_known(const struct hatch_place *place, double limit_rad);

#endif
