// Numbers of the strips of paper that a collage is made of: of an item and of a band of tone. 0: no strip. Floats of 32
// bits hold them exactly.
#define STRIP_BANDS 16
#define STRIP_ITEMS 1000000

float strip_number(int item, int band)
{
    return float(item % STRIP_ITEMS * STRIP_BANDS + band + 1);
}

float strip_band(float strip)
{
    return mod(strip - 1.0, float(STRIP_BANDS));
}

bool same_item(float strip, float other)
{
    return floor((strip - 1.0) / float(STRIP_BANDS)) == floor((other - 1.0) / float(STRIP_BANDS));
}
