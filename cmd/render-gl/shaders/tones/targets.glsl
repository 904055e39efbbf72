// Tones of the columns. A place among the columns is 0 for paper, 1 for the first column, n for the last; its fraction
// blends two neighbours.
#include "frame/frame.glsl"

float target(int column)
{
    return targets[column >> 2][column & 3];
}

// Place among the columns whose blend has a mean tone equal to the amount.
float place_of(float amount)
{
    int low = 0, high = counts.y;
    while (low < high) {
        int middle = (low + high) >> 1;
        if (target(middle) < amount)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == counts.y)
        return float(counts.y);
    float begin = low > 0 ? target(low - 1) : 0.0;
    return float(low) + clamp((amount - begin) / max(target(low) - begin, 1e-6), 0.0, 1.0);
}
