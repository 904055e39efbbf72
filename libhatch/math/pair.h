/* Double-double arithmetic: a number is the unevaluated sum of two doubles, with about 106 bits of precision (Dekker
 * 1971; error-free sums by Knuth, error-free products by fused multiply-add). The compiler must not contract or reorder
 * operations (-ffp-contract=off, no -ffast-math). */
#ifndef HATCH_MATH_PAIR_H
#define HATCH_MATH_PAIR_H

#include <math.h>

struct hatch_pair {
    double high, low; /* |low| is at most half a unit in the last place of high */
};

/* Converts a double, exactly. */
static inline struct hatch_pair hatch_pair_of(double a)
{
    return (struct hatch_pair){a, 0};
}

/* Rounds to a double. */
static inline double hatch_pair_round(struct hatch_pair a)
{
    return a.high + a.low;
}

/* a + b, exactly */
static inline struct hatch_pair hatch_pair_sum(double a, double b)
{
    double sum = a + b, of_b = sum - a;
    return (struct hatch_pair){sum, (a - (sum - of_b)) + (b - of_b)};
}

/* a * b, exactly */
static inline struct hatch_pair hatch_pair_product(double a, double b)
{
    double product = a * b;
    return (struct hatch_pair){product, fma(a, b, -product)};
}

/* a + b; the same to the last bit as b + a */
static inline struct hatch_pair hatch_pair_add(struct hatch_pair a, struct hatch_pair b)
{
    struct hatch_pair high = hatch_pair_sum(a.high, b.high), low = hatch_pair_sum(a.low, b.low);
    high = hatch_pair_sum(high.high, high.low + low.high);
    return hatch_pair_sum(high.high, high.low + low.low);
}

/* a - b */
static inline struct hatch_pair hatch_pair_sub(struct hatch_pair a, struct hatch_pair b)
{
    return hatch_pair_add(a, (struct hatch_pair){-b.high, -b.low});
}

/* a / 2, exactly */
static inline struct hatch_pair hatch_pair_half(struct hatch_pair a)
{
    return (struct hatch_pair){0.5 * a.high, 0.5 * a.low};
}

/* a * by */
static inline struct hatch_pair hatch_pair_scale(struct hatch_pair a, double by)
{
    struct hatch_pair high = hatch_pair_product(a.high, by);
    return hatch_pair_sum(high.high, high.low + a.low * by);
}

/* a * b */
static inline struct hatch_pair hatch_pair_mul(struct hatch_pair a, struct hatch_pair b)
{
    struct hatch_pair high = hatch_pair_product(a.high, b.high);
    return hatch_pair_sum(high.high, high.low + (a.high * b.low + a.low * b.high));
}

/* a / b */
static inline struct hatch_pair hatch_pair_div(struct hatch_pair a, struct hatch_pair b)
{
    struct hatch_pair sum = {0, 0};
    for (int i = 0; i < 3; i++) {
        double part = a.high / b.high;
        sum = hatch_pair_add(sum, hatch_pair_of(part));
        a = hatch_pair_sub(a, hatch_pair_scale(b, part));
    }
    return sum;
}

/* The largest whole number that is at most a. */
static inline struct hatch_pair hatch_pair_floor(struct hatch_pair a)
{
    double whole = floor(a.high);
    return hatch_pair_sum(whole, whole < a.high ? 0.0 : floor(a.low));
}

/* The dot product of two vectors. */
static inline struct hatch_pair hatch_pair_dot(const struct hatch_pair a[3], const double b[3])
{
    struct hatch_pair sum = hatch_pair_scale(a[0], b[0]);
    for (int k = 1; k < 3; k++)
        sum = hatch_pair_add(sum, hatch_pair_scale(a[k], b[k]));
    return sum;
}

#endif
