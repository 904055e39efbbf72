// The tones of the columns. A place among the columns is 0 for paper, 1 for the first of n columns and n for the last;
// a fraction stands for a blend of the two neighbours.
#include "frame/frame.glsl"

float target(int column)
{
    return targets[column >> 2][column & 3];
}

// Returns the place among the columns at which their blend has the amount as its mean tone.
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
