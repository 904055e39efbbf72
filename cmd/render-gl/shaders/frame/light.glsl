#include "frame/frame.glsl"

// SUN is defined if there is one light only, and it is directional. This is a case at compile time, because software
// renderers are slow at variable indices and execute both branches of every `if`.
#ifdef SUN
#define LIGHTS 1
#define IS_LAMP(light) false
#else
#define LIGHTS counts.x
#define IS_LAMP(light) (lights[light].position.w > 0.0)
#endif
#include "shadow/shadow.glsl"

// Returns the ambient and diffuse light and the highlights at a point of the unit scene: 0: dark, 1 or more: fully
// lit. normal: shading normal, of unit length; face: geometric normal, for shadows.
float light_at(vec3 point, vec3 normal, vec3 face)
{
    float sum = shade.y;
    for (int i = 0; i < LIGHTS; i++) {
        vec3 to_light = lights[i].direction.xyz;
        float strength = lights[i].direction.w;
        if (IS_LAMP(i)) {
            vec3 from = lights[i].position.xyz - point;
            float square = max(dot(from, from), lights[i].cone.w);
            to_light = from * inversesqrt(square);
            float spot = clamp(dot(lights[i].direction.xyz, -to_light) * lights[i].cone.x +
                               lights[i].cone.y, 0.0, 1.0);
            float far = square * lights[i].cone.z;
            strength *= spot * spot * clamp(1.0 - far * far, 0.0, 1.0) / square;
        }
        float facing = max(dot(normal, to_light), 0.0);
        if (facing > 0.0)
            strength *= lit_share(i, point, face, to_light);
        sum += strength * facing;
#ifdef HIGHLIGHTS
        if (facing > 0.0) {
            vec3 to_eye = normalize(eye.xyz - eye.w * point);
            float mirror = max(dot(normal, normalize(to_light + to_eye)), 0.0);
            sum += strength * shade.z * pow(mirror, shade.w);
        }
#endif
    }
    return sum;
}

// Returns the amounts of both inks, 0 .. 1, for a darkness, 0 .. 1.
vec2 two_amounts(float dark)
{
    return mix(curve.xx, curve.yy, vec2(max(2.0 * dark - 1.0, 0.0), max(1.0 - 2.0 * dark, 0.0)));
}

// Returns the amounts of the dark and of the light ink, 0 .. 1, for a lightness.
vec2 ink_amounts(float lightness)
{
    float dark = pow(1.0 - clamp(lightness, 0.0, 1.0), curve.z);
    if (counts.z == 2)
        return two_amounts(dark);
    return vec2(mix(curve.x, curve.y, counts.z == 1 ? 1.0 - dark : dark), 0.0); // a single ink has no light one
}
