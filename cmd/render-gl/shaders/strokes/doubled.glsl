// Returns the direction with twice the angle, which is the same for a direction and its opposite; zero for none.
vec2 doubled(vec2 way)
{
    float square = dot(way, way);
    return square > 0.0 ? vec2(way.x * way.x - way.y * way.y, 2.0 * way.x * way.y) / square : vec2(0.0);
}
