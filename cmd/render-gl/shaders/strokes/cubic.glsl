// The fit of cubics to fragments: libhatch/fit/cubic.c, where it is explained.
#include "strokes/curve.glsl"

layout(std430, binding = STORAGE_SORTED) readonly buffer Sorted { uvec2 sorted[]; };

const int SUM_BITS = 53, GRID_BITS = 19, SHARE_BITS_LEAST = 7;
const double PENALTY = 2.0, SHORT_PX = 50.0;
const int PASSES = 4;

void legendre(float u, out float values[7])
{
    values[0] = 1.0;
    values[1] = u;
    for (int k = 2; k < 7; k++)
        values[k] = (float(2 * k - 1) * u * values[k - 1] - float(k - 1) * values[k - 2]) / float(k);
}

// Finds the ranges of the fragments first .. first + count - 1. Returns the greatest coordinate from the origin.
float find_range(uint first, uint count, inout Cubic cubic)
{
    double weight = 0.0;
    vec2 far = vec2(0.0);
    cubic.range = vec2(2.0, -1.0);
    cubic.origin = vec2(1e9);
    for (uint i = first; i < first + count; i++) {
        float t = t_of(sorted[i]);
        cubic.range = vec2(min(cubic.range.x, t), max(cubic.range.y, t));
        cubic.origin = min(cubic.origin, pixel_of(sorted[i]));
        far = max(far, pixel_of(sorted[i]));
        weight += double(sorted[i].y >> 16);
    }
    cubic.weight = float(weight / 65535.0);
    return max(far.x - cubic.origin.x, far.y - cubic.origin.y);
}

// Sums over the fragments, which doubles hold exactly, in any order.
// extent: greatest coordinate from the origin
void add_all(uint first, uint count, float extent, Cubic cubic, out double moments[7], out double x[4], out double y[4])
{
    for (int k = 0; k < 7; k++)
        moments[k] = 0.0;
    for (int k = 0; k < 4; k++)
        x[k] = y[k] = 0.0;
    int rest = SUM_BITS - (findMSB(count - 1u) + 1) - (findMSB(uint(extent)) + 1);
    int share_bits = clamp(rest - GRID_BITS, SHARE_BITS_LEAST, SHARE_BITS);
    float grid = exp2(float(min(GRID_BITS, rest - share_bits)));
    for (uint i = first; i < first + count; i++) {
        vec2 from = pixel_of(sorted[i]) - cubic.origin;
        double share = double(share_of(sorted[i], share_bits));
        float values[7];
        legendre(u_of(cubic, t_of(sorted[i])), values);
        for (int k = 0; k < 7; k++) {
            double value = share * double(roundEven(values[k] * grid) / grid);
            moments[k] += value;
            if (k < 4) {
                x[k] += value * double(from.x);
                y[k] += value * double(from.y);
            }
        }
    }
}

// Computes the sums of products of the first four polynomials from the moments; the lower half.
void products(double m[7], out double a[4][4])
{
    for (int k = 0; k < 4; k++)
        a[k][0] = m[k];
    a[1][1] = (2.0 * m[2] + m[0]) / 3.0;
    a[2][1] = (3.0 * m[3] + 2.0 * m[1]) / 5.0;
    a[3][1] = (4.0 * m[4] + 3.0 * m[2]) / 7.0;
    a[2][2] = 18.0 * m[4] / 35.0 + 2.0 * m[2] / 7.0 + m[0] / 5.0;
    a[3][2] = 10.0 * m[5] / 21.0 + 4.0 * m[3] / 15.0 + 9.0 * m[1] / 35.0;
    a[3][3] = 100.0 * m[6] / 231.0 + 18.0 * m[4] / 77.0 + 4.0 * m[2] / 21.0 + m[0] / 7.0;
}

// Computes the penalties on the factors, from the length of the line through the fragments and their mean weight.
void find_penalties(double a[4][4], double x[4], double y[4], uint count, out double penalty[4])
{
    double share = a[1][0] / a[0][0], spread = a[1][1] - share * a[1][0] + 1e-9LF;
    double half_x = (x[1] - share * x[0]) / spread, half_y = (y[1] - share * y[0]) / spread;
    penalty[0] = 0.0LF;
    penalty[1] = 1e-9LF;
    double square = 4.0LF * (half_x * half_x + half_y * half_y);
    penalty[2] = PENALTY * a[0][0] / double(count) / (1.0LF + square / (SHORT_PX * SHORT_PX));
    penalty[3] = penalty[2];
}

// Factors a matrix as L D L^T.
void factorize(inout double a[4][4], out double pivots[4])
{
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < i; j++) {
            for (int k = 0; k < j; k++)
                a[i][j] -= a[i][k] * pivots[k] * a[j][k];
            a[i][j] /= pivots[j];
            a[i][i] -= a[i][j] * a[i][j] * pivots[j];
        }
        pivots[i] = a[i][i];
    }
}

// Solves the factored system several times; each time the penalties are on the distance from the last solution.
vec4 solve(double a[4][4], double pivots[4], double penalty[4], double right[4])
{
    double x[4];
    for (int k = 0; k < 4; k++)
        x[k] = 0.0LF;
    for (int n = 0; n < PASSES; n++) {
        for (int i = 0; i < 4; i++) {
            x[i] = right[i] + penalty[i] * x[i];
            for (int j = 0; j < i; j++)
                x[i] -= a[i][j] * x[j];
        }
        for (int i = 3; i >= 0; i--) {
            x[i] /= pivots[i];
            for (int j = i + 1; j < 4; j++)
                x[i] -= a[j][i] * x[j];
        }
    }
    return vec4(x[0], x[1], x[2], x[3]);
}

Cubic fit(uint first, uint count)
{
    Cubic cubic;
    double moments[7], x[4], y[4], a[4][4], penalty[4], pivots[4];
    float extent = find_range(first, count, cubic);
    add_all(first, count, extent, cubic, moments, x, y);
    products(moments, a);
    find_penalties(a, x, y, count, penalty);
    for (int k = 0; k < 4; k++)
        a[k][k] += penalty[k];
    factorize(a, pivots);
    cubic.x = solve(a, pivots, penalty, x);
    cubic.y = solve(a, pivots, penalty, y);
    return cubic;
}
