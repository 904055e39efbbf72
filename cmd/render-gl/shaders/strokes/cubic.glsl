// The fit of cubics to fragments: libhatch/fit/cubic.c, where it is explained.
struct Cubic {
    vec2 range;  // of t
    vec2 origin; // in pixels
    vec4 x, y;   // factors of Legendre polynomials 0 to 3
    float weight;
};

layout(std430, binding = STORAGE_SORTED) readonly buffer Sorted { uvec2 sorted[]; };

const float GRID = 1048576.0, PIVOT_LEAST = 1e-3;

float t_of(uvec2 fragment)
{
    return float(fragment.y & 0xffffu) / 65535.0;
}

vec2 pixel_of(uvec2 fragment)
{
    return vec2(fragment.x & 0xffffu, fragment.x >> 16) + 0.5;
}

float u_of(Cubic cubic, float t)
{
    float half_range = 0.5 * (cubic.range.y - cubic.range.x);
    return half_range > 0.0 ? (t - cubic.range.x) / half_range - 1.0 : 0.0;
}

void legendre(float u, out float values[7])
{
    values[0] = 1.0;
    values[1] = u;
    for (int k = 2; k < 7; k++)
        values[k] = (float(2 * k - 1) * u * values[k - 1] - float(k - 1) * values[k - 2]) / float(k);
}

// Finds the ranges of the fragments first .. first + count - 1.
void find_range(uint first, uint count, inout Cubic cubic)
{
    double weight = 0.0;
    cubic.range = vec2(2.0, -1.0);
    cubic.origin = vec2(1e9);
    for (uint i = first; i < first + count; i++) {
        float t = t_of(sorted[i]);
        cubic.range = vec2(min(cubic.range.x, t), max(cubic.range.y, t));
        cubic.origin = min(cubic.origin, pixel_of(sorted[i]));
        weight += double(sorted[i].y >> 16);
    }
    cubic.weight = float(weight / 65535.0);
}

// Sums over the fragments, which doubles hold exactly, in any order.
void add_all(uint first, uint count, Cubic cubic, out double moments[7], out double x[4], out double y[4])
{
    for (int k = 0; k < 7; k++)
        moments[k] = 0.0;
    for (int k = 0; k < 4; k++)
        x[k] = y[k] = 0.0;
    for (uint i = first; i < first + count; i++) {
        vec2 from = pixel_of(sorted[i]) - cubic.origin;
        float values[7];
        legendre(u_of(cubic, t_of(sorted[i])), values);
        for (int k = 0; k < 7; k++) {
            double value = double(roundEven(values[k] * GRID) / GRID);
            moments[k] += value;
            if (k < 4) {
                x[k] += value * double(from.x);
                y[k] += value * double(from.y);
            }
        }
    }
}

// Factors the system as L D L^T and solves it, up to the first polynomial that the lower ones nearly explain.
void solve(double m[7], inout double x[4], inout double y[4])
{
    double a[4][4], pivots[4];
    int n = 0;
    for (int k = 0; k < 4; k++)
        a[k][0] = m[k];
    a[1][1] = (2.0 * m[2] + m[0]) / 3.0;
    a[2][1] = (3.0 * m[3] + 2.0 * m[1]) / 5.0;
    a[3][1] = (4.0 * m[4] + 3.0 * m[2]) / 7.0;
    a[2][2] = 18.0 * m[4] / 35.0 + 2.0 * m[2] / 7.0 + m[0] / 5.0;
    a[3][2] = 10.0 * m[5] / 21.0 + 4.0 * m[3] / 15.0 + 9.0 * m[1] / 35.0;
    a[3][3] = 100.0 * m[6] / 231.0 + 18.0 * m[4] / 77.0 + 4.0 * m[2] / 21.0 + m[0] / 7.0;
    for (; n < 4; n++) {
        double whole = a[n][n];
        for (int j = 0; j < n; j++) {
            for (int k = 0; k < j; k++)
                a[n][j] -= a[n][k] * pivots[k] * a[j][k];
            a[n][j] /= pivots[j];
            a[n][n] -= a[n][j] * a[n][j] * pivots[j];
        }
        pivots[n] = a[n][n];
        if (!(pivots[n] > double(PIVOT_LEAST) * whole))
            break;
    }
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < i && i < n; j++) {
            x[i] -= a[i][j] * x[j];
            y[i] -= a[i][j] * y[j];
        }
    for (int i = 3; i >= 0; i--) {
        x[i] = i < n ? x[i] / pivots[i] : 0.0;
        y[i] = i < n ? y[i] / pivots[i] : 0.0;
        for (int j = i + 1; j < n; j++) {
            x[i] -= a[j][i] * x[j];
            y[i] -= a[j][i] * y[j];
        }
    }
}

Cubic fit(uint first, uint count)
{
    Cubic cubic;
    double moments[7], x[4], y[4];
    find_range(first, count, cubic);
    add_all(first, count, cubic, moments, x, y);
    solve(moments, x, y);
    cubic.x = vec4(x[0], x[1], x[2], x[3]);
    cubic.y = vec4(y[0], y[1], y[2], y[3]);
    return cubic;
}

// Returns the place at u, in pixels; beyond -1 and 1 along the tangents.
vec2 place_on(Cubic cubic, float u)
{
    float inside = clamp(u, -1.0, 1.0), square = inside * inside;
    vec4 values = vec4(1.0, inside, 1.5 * square - 0.5, (2.5 * square - 1.5) * inside);
    values += (u - inside) * vec4(0.0, 1.0, 3.0 * inside, 7.5 * square - 1.5);
    return cubic.origin + vec2(dot(cubic.x, values), dot(cubic.y, values));
}
