/* Faces laid out in the plane, and walks over them, against plane and solid geometry. */
#include "field_make.h"
#include "trace/ground.h"

static struct hatch_trace_ground lay_out(const struct field_case *field, double angle_rad, double hard_rad)
{
    struct hatch_trace_ground ground;
    HATCH_TEST_OK(hatch_trace_lay_out(&field->surface, &field->frames, field->direction, angle_rad, hard_rad, &keep,
                                      &ground, &err),
                  &err);
    return ground;
}

static void place_at(const struct hatch_trace_ground *ground, const struct hatch_trace_place *place, double at[3])
{
    hatch_trace_position(&ground->poses[place->face], place->x, place->y, at);
}

static void heading_of(const struct hatch_trace_ground *ground, const struct hatch_trace_place *place, double at[3])
{
    float vector[3];
    hatch_trace_vector(&ground->poses[place->face], place->heading, vector);
    hatch_vec_of(vector, at);
}

/* The middle of a face, heading from its corner 0 to 1, turned by an angle. */
static struct hatch_trace_place middle_of(const struct hatch_trace_ground *ground, uint32_t face, double angle_rad)
{
    const struct hatch_trace_face *of = &ground->faces[face];
    return (struct hatch_trace_place){
        face, ((double)of->x1 + (double)of->x2) / 3, (double)of->y2 / 3, {cos(angle_rad), sin(angle_rad)}};
}

static void check_near(const double *a, const double *b, double tolerance)
{
    ck_assert_msg(hatch_vec_distance(a, b) <= tolerance, "%g %g %g, want %g %g %g", a[0], a[1], a[2], b[0], b[1], b[2]);
}

/* Faces in any order are numbered along a curve: those with successive numbers are near each other. On a plane of edges
 * of length 1 random faces would be some 20 apart. */
START_TEST(successive_faces_are_near)
{
    struct field_case plane = case_of_shape(HATCH_SHAPE_PLANE, 3000, 1);
    struct hatch_mesh mesh = plane.mesh;
    for (uint32_t f = mesh.face_count - 1; f > 0; f--) {
        uint32_t other = (uint32_t)(hatch_random_u64(5, 0, f) % (f + 1)), face[3];
        memcpy(face, &mesh.indices[3 * f], sizeof face);
        memcpy(&mesh.indices[3 * f], &mesh.indices[3 * other], sizeof face);
        memcpy(&mesh.indices[3 * other], face, sizeof face);
    }
    struct field_case field = case_of(mesh);
    set_direction(&field, 1, 0, 0);
    struct hatch_trace_ground ground = lay_out(&field, 0, PI);
    double sum = 0, before[3], at[3];
    for (uint32_t f = 0; f < mesh.face_count; f++) {
        hatch_vec_copy(&field.surface.points[3 * (size_t)field.surface.corners[3 * ground.source[f]]], at);
        sum += f ? hatch_vec_distance(before, at) / mesh.face_count : 0;
        hatch_vec_copy(at, before);
    }
    ck_assert_double_lt(sum, 3);
}
END_TEST

/* Lengths and places are those in space, on faces of any form. */
START_TEST(a_face_keeps_its_form)
{
    struct field_case field = case_of_shape(HATCH_SHAPE_ELLIPSOID, 300, 1);
    struct hatch_trace_ground ground = lay_out(&field, 0, PI);
    for (uint32_t f = 0; f < field.surface.face_count; f++) {
        const struct hatch_trace_face *face = &ground.faces[f];
        const double flat[3][2] = {{0, 0}, {(double)face->x1, 0}, {(double)face->x2, (double)face->y2}};
        ck_assert(face->x1 > 0 && face->y2 > 0);
        for (uint32_t c = 0; c < 3; c++) {
            const struct hatch_trace_place place = {f, flat[c][0], flat[c][1], {1, 0}};
            double at[3], share[3];
            place_at(&ground, &place, at);
            check_near(at, &field.surface.points[3 * field.surface.corners[3 * ground.source[f] + c]], 1e-5);
            hatch_trace_shares(face, place.x, place.y, share);
            for (uint32_t k = 0; k < 3; k++)
                ck_assert_double_eq_tol(share[k], k == c ? 1 : 0, 1e-6);
        }
    }
}
END_TEST

/* Returns how many sides end the ground of 16 by 16 squares over dyadic x and y, so that nothing is rounded.
 *   rise  slope along x that the half of greater x has more than the other */
static uint32_t count_ends(double rise, double hard_rad)
{
    struct hatch_mesh mesh;
    HATCH_TEST_OK(hatch_mesh_make(&keep, 17 * 17, 512, &mesh, &err), &err);
    for (uint32_t v = 0; v < 17 * 17; v++) {
        float x = (float)(v % 17) / 16, y = (float)(v / 17) / 16;
        const float at[3] = {x, y, x + 2 * y + (float)rise * fmaxf(x - 0.5f, 0)};
        memcpy(&mesh.attributes[0].data[3 * v], at, sizeof at);
    }
    for (uint32_t q = 0; q < 256; q++) {
        uint32_t a = q / 16 * 17 + q % 16;
        const uint32_t faces[6] = {a, a + 1, a + 18, a, a + 18, a + 17};
        memcpy(&mesh.indices[6 * q], faces, sizeof faces);
    }
    struct field_case field = case_of(mesh);
    set_direction(&field, 1, 0, 1);
    struct hatch_trace_ground ground = lay_out(&field, 0, hard_rad);
    uint32_t ends = 0;
    for (uint32_t side = 0; side < 3 * 512; side++)
        ends += ground.faces[side / 3].beyond[side % 3] == HATCH_NO_SIDE;
    return ends;
}

/* Flat edges have no angle, and the smallest bends have theirs. */
START_TEST(only_larger_angles_are_hard)
{
    const double rise = 0x1p-12;
    /* Normals (-1, -2, 1) and (-1 - rise, -2, 1), whose cross product is rise * (0, -1, -2). */
    double bend = atan2(rise * sqrt(5), 6 + rise);
    ck_assert_uint_eq(count_ends(0, 0), 64);
    ck_assert_uint_eq(count_ends(rise, 1.1 * bend), 64);
    ck_assert_uint_eq(count_ends(rise, 0.9 * bend), 64 + 2 * 16);
    ck_assert_uint_eq(count_ends(rise, 0), 64 + 2 * 16);
}
END_TEST

/* On a plane, the direction is the field turned counter-clockwise; its sign is that of the heading. */
START_TEST(the_direction_is_the_field_turned)
{
    struct field_case plane = case_of_shape(HATCH_SHAPE_PLANE, 200, 1);
    set_direction(&plane, 3, 1, 0);
    for (int degrees = -350; degrees <= 360; degrees += 10) {
        double angle = atan2(1, 3) + degrees * PI / 180, direction[2], got[3];
        struct hatch_trace_ground ground = lay_out(&plane, degrees * PI / 180, PI);
        const double line[3] = {cos(angle), sin(angle), 0};
        for (uint32_t f = 0; f < plane.surface.face_count; f += 7)
            for (int turn = 0; turn < 8; turn++) {
                struct hatch_trace_place place = middle_of(&ground, f, 0.3 + turn * PI / 4);
                double before[3];
                heading_of(&ground, &place, before);
                ck_assert(hatch_trace_direction(&ground, &place, direction));
                memcpy(place.heading, direction, sizeof direction);
                heading_of(&ground, &place, got);
                ck_assert_double_eq_tol(fabs(hatch_vec_dot(got, line)), 1, 1e-6);
                ck_assert_double_ge(hatch_vec_dot(got, before), -1e-6);
            }
    }
}
END_TEST

/* A field that turns by thirds of a half turn around a triangle cancels out in its middle. */
START_TEST(a_singularity_has_no_direction)
{
    static const float corners[9] = {0, 1, 0, -0.866f, -0.5f, 0, 0.866f, -0.5f, 0};
    static const uint32_t indices[3] = {0, 1, 2};
    struct field_case field = case_of(mesh_of(corners, 3, indices, 1));
    for (uint32_t p = 0; p < 3; p++)
        for (int k = 0; k < 2; k++)
            field.direction[3 * p + (size_t)k] = (k ? sin : cos)(p * PI / 3);
    struct hatch_trace_ground ground = lay_out(&field, 0.4, PI);
    struct hatch_trace_place place = middle_of(&ground, 0, 0);
    struct hatch_trace_leg leg;
    double direction[2];
    ground.calm = 1;
    ck_assert(!hatch_trace_direction(&ground, &place, direction));
    ck_assert(!hatch_trace_walk(&ground, &place, 1, HATCH_TRACE_ALONG, &leg));
    ck_assert_double_eq(leg.length, 0);
    place.y *= 0.7;
    ck_assert(hatch_trace_direction(&ground, &place, direction));
    ck_assert(hatch_trace_walk(&ground, &place, 0.01, HATCH_TRACE_ALONG, &leg));
    ck_assert_double_eq(leg.length, 0.01);
}
END_TEST

/* Returns whether there is a direction so far above the middle of the first face. */
static bool has_direction(const struct hatch_trace_ground *ground, double above)
{
    struct hatch_trace_place place = middle_of(ground, 0, 0);
    double direction[2];
    place.y += above;
    return hatch_trace_direction(ground, &place, direction);
}

/* On the triangle of the test before, whose sides have a length of 1 in surface units, directions change alike in all
 * directions; on the other two, they turn by nearly a right angle on the way up, and do not differ aside. */
START_TEST(large_faces_have_directions_next_to_singularities)
{
    static const float corners[9] = {0, 1, 0, -0.866f, -0.5f, 0, 0.866f, -0.5f, 0};
    static const float square[12] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
    static const uint32_t indices[3] = {0, 1, 2}, two[6] = {0, 1, 2, 0, 2, 3};
    struct field_case field = case_of(mesh_of(corners, 3, indices, 1)), turned = case_of(mesh_of(square, 4, two, 2));
    for (uint32_t p = 0; p < 3; p++)
        for (int k = 0; k < 2; k++)
            field.direction[3 * p + (size_t)k] = (k ? sin : cos)(p * PI / 3);
    struct hatch_trace_ground ground = lay_out(&field, 0, PI);
    const double limits[3][2] = {{0.01, 0.01414}, {0.05, 0.0707}, {1, 0.0866}}; /* calm, and how far it reaches */
    for (int i = 0; i < 3; i++) {
        ground.calm = limits[i][0];
        ck_assert(!has_direction(&ground, 0.98 * limits[i][1]));
        ck_assert(has_direction(&ground, 1.02 * limits[i][1]));
    }
    for (uint32_t p = 0; p < 4; p++) {
        double *to = &turned.direction[3 * (size_t)p], angle = p < 2 ? 0.01 : PI / 2;
        to[0] = cos(angle);
        to[1] = sin(angle);
    }
    ground = lay_out(&turned, 0, PI);
    ground.calm = 0.01;
    double turn = (double)ground.faces[0].y2 / 6; /* half-way up: the middle of a face is a third up */
    for (int i = 0; i < 64; i++) {
        double above = (i + 0.5) / 64 * turn * 4 - turn;
        ck_assert_msg(has_direction(&ground, above) == (fabs(above - turn) > 0.01), "%g of %g", above, turn);
    }
}
END_TEST

/* Walks until the length is reached or the walk ends; returns the length walked. */
static double walk(const struct hatch_trace_ground *ground, struct hatch_trace_place *place, double length,
                   enum hatch_trace_way way)
{
    double walked = 0, last[3], at[3];
    bool goes_on = true;
    for (int n = 0; goes_on && length - walked > 1e-9 && n < 10000; n++) {
        struct hatch_trace_leg leg;
        place_at(ground, place, last);
        goes_on = hatch_trace_walk(ground, place, length - walked, way, &leg);
        place_at(ground, place, at);
        ck_assert_double_eq_tol(hatch_vec_distance(last, at), leg.length, 1e-4);
        walked += leg.length;
    }
    return walked;
}

START_TEST(a_walk_over_a_plane_is_straight)
{
    struct field_case plane = case_of_shape(HATCH_SHAPE_PLANE, 2000, 1);
    set_direction(&plane, 1, 0, 0);
    double angle = 1.1, scale = plane.surface.components[0].scale;
    struct hatch_trace_ground ground = lay_out(&plane, angle, 0.1);
    for (uint32_t f = 0; f < plane.surface.face_count; f += 13)
        for (int way = HATCH_TRACE_ALONG; way <= HATCH_TRACE_STRAIGHT; way++) {
            struct hatch_trace_place place = middle_of(&ground, f, 0.2);
            double from[3], heading[3], to[3], wanted[3];
            if (way == HATCH_TRACE_ALONG)
                ck_assert(hatch_trace_direction(&ground, &place, place.heading));
            place_at(&ground, &place, from);
            heading_of(&ground, &place, heading);
            double walked = walk(&ground, &place, 8, (enum hatch_trace_way)way);
            place_at(&ground, &place, to);
            hatch_vec_add_scaled(from, walked, heading, wanted);
            check_near(to, wanted, 1e-3);
            /* A shorter walk has met the border of the plane. */
            double outermost = fmax(fabs(to[0]), fabs(to[1])) * scale;
            if (walked < 8 - 1e-6)
                ck_assert_double_eq_tol(outermost, 1, 1e-4);
            else
                ck_assert_double_le(outermost, 1 + 1e-4);
        }
}
END_TEST

/* Around a cube, parallel to its edges: a geodesic that closes after four sides. */
START_TEST(a_walk_around_a_cube_closes)
{
    struct field_case box = case_of(cube(-1, 1));
    struct hatch_trace_ground ground = lay_out(&box, 0, 1.6), hard = lay_out(&box, 0, 1.5);
    double side = 2 / box.surface.components[0].scale, from[3], to[3];
    for (uint32_t f = 0; f < 12; f++) {
        struct hatch_trace_place place = middle_of(&ground, f, 0), start;
        double heading[3];
        heading_of(&ground, &place, heading);
        /* Side 0 of a face may be a diagonal: head along the axis that is nearest. */
        double tilt = hypot(heading[0], hypot(heading[1], heading[2])) -
                      fmax(fabs(heading[0]), fmax(fabs(heading[1]), fabs(heading[2])));
        if (tilt > 0.1)
            place = middle_of(&ground, f, PI / 4);
        start = place;
        place_at(&ground, &place, from);
        ck_assert_double_eq_tol(walk(&ground, &place, 4 * side, HATCH_TRACE_STRAIGHT), 4 * side, 1e-9);
        place_at(&ground, &place, to);
        check_near(to, from, 1e-4);
        ck_assert_double_lt(walk(&hard, &start, 4 * side, HATCH_TRACE_STRAIGHT), side);
    }
}
END_TEST

/* Returns the angle between the outsides of two faces at an edge, where an edge that the surface runs contrary across
 * has them on opposite sides. */
static double bend_of(const struct field_case *field, uint32_t side, uint32_t other)
{
    double a[3], b[3];
    hatch_surface_face_normal(&field->surface, side / 3, a);
    hatch_surface_face_normal(&field->surface, other / 3, b);
    double cosine = hatch_vec_dot(a, b) / hatch_vec_length(a) / hatch_vec_length(b);
    bool contrary = field->surface.corners[side] == field->surface.corners[other];
    return acos(fmin(1, fmax(-1, contrary ? -cosine : cosine)));
}

/* Crosses every edge from the middle of a face towards a point of the edge: the heading keeps its angle to the edge and
 * leads on into the other face, also across a contrary edge. */
static uint32_t check_crossings(const struct field_case *field, double hard_rad)
{
    const struct hatch_surface *surface = &field->surface;
    struct hatch_trace_ground ground = lay_out(field, 0, hard_rad);
    uint32_t contrary = 0;
    for (uint32_t i = 0; i < 3 * surface->face_count; i++) {
        uint32_t c = i % 3, side = 3 * ground.source[i / 3] + c, other = surface->opposite[side];
        const struct hatch_trace_face *face = &ground.faces[i / 3];
        const double flat[3][2] = {{0, 0}, {(double)face->x1, 0}, {(double)face->x2, (double)face->y2}};
        struct hatch_trace_place place = middle_of(&ground, i / 3, 0);
        struct hatch_trace_leg leg;
        double edge[3], heading[3], before, met[3], at[3], inwards[3], length = 0;
        for (int k = 0; k < 2; k++)
            place.heading[k] = 0.3 * flat[c][k] + 0.7 * flat[(c + 1) % 3][k] - (k ? place.y : place.x);
        length = hypot(place.heading[0], place.heading[1]);
        for (int k = 0; k < 2; k++)
            place.heading[k] /= length;
        hatch_vec_sub(&surface->points[3 * surface->corners[3 * (side / 3) + (c + 1) % 3]],
                      &surface->points[3 * surface->corners[side]], edge);
        heading_of(&ground, &place, heading);
        before = hatch_vec_dot(heading, edge);
        bool goes_on = hatch_trace_walk(&ground, &place, 100, HATCH_TRACE_STRAIGHT, &leg);
        ck_assert_double_eq_tol(leg.length, length, 1e-5 * length);
        ck_assert_int_eq(goes_on, other != HATCH_NO_SIDE && bend_of(field, side, other) <= hard_rad);
        if (!goes_on)
            continue;
        ck_assert_uint_eq(ground.source[place.face], other / 3);
        heading_of(&ground, &place, heading);
        ck_assert_double_eq_tol(hatch_vec_dot(heading, edge), before, 1e-4 * hatch_vec_length(edge));
        for (int k = 0; k < 3; k++)
            met[k] = 0.3 * surface->points[3 * surface->corners[side] + (size_t)k] +
                     0.7 * surface->points[3 * surface->corners[3 * (side / 3) + (c + 1) % 3] + (size_t)k];
        place_at(&ground, &place, at);
        check_near(at, met, 1e-4);
        struct hatch_trace_place inside = middle_of(&ground, place.face, 0);
        place_at(&ground, &inside, inwards);
        hatch_vec_sub(inwards, at, inwards);
        hatch_vec_add_scaled(inwards, -hatch_vec_dot(inwards, edge) / hatch_vec_dot(edge, edge), edge, inwards);
        ck_assert_double_gt(hatch_vec_dot(heading, inwards), 0);
        contrary += surface->corners[side] == surface->corners[other];
    }
    return contrary;
}

START_TEST(headings_keep_their_angle_to_edges)
{
    struct field_case round = case_of_shape(HATCH_SHAPE_SPHERE, 300, 1), strip = case_of(band(40, 3, true));
    struct field_case bottle = case_of(klein(12, 10)), box = case_of(cube(0, 1));
    ck_assert_uint_eq(check_crossings(&round, 0.25), 0);
    ck_assert_uint_eq(check_crossings(&box, 0.7), 0);
    ck_assert_uint_gt(check_crossings(&strip, 0.7), 0);
    ck_assert_uint_gt(check_crossings(&bottle, 1), 0);
}
END_TEST

/* On a Möbius strip, the line at 60 degrees to the field is one at -60 degrees beyond the edge where the outside
 * changes: strokes end there, and go on at right angles to the field. */
START_TEST(slanted_strokes_end_where_the_outside_changes)
{
    struct field_case strip = case_of(band(40, 3, true));
    const struct hatch_surface *surface = &strip.surface;
    static const double degrees[] = {0, 90, -180, 60, 45};
    for (size_t a = 0; a < sizeof degrees / sizeof *degrees; a++) {
        struct hatch_trace_ground ground = lay_out(&strip, degrees[a] * PI / 180, PI);
        uint32_t contrary = 0, closed = 0;
        for (uint32_t i = 0; i < 3 * surface->face_count; i++) {
            uint32_t side = 3 * ground.source[i / 3] + i % 3, other = surface->opposite[side];
            if (other == HATCH_NO_SIDE)
                continue;
            bool turns = surface->corners[side] == surface->corners[other];
            contrary += turns;
            closed += ground.faces[i / 3].beyond[i % 3] == HATCH_NO_SIDE;
            ck_assert(turns || ground.faces[i / 3].beyond[i % 3] != HATCH_NO_SIDE);
        }
        ck_assert_uint_gt(contrary, 0);
        ck_assert_uint_eq(closed, a < 3 ? 0 : contrary);
    }
}
END_TEST

START_TEST(a_turn_is_a_right_angle)
{
    struct hatch_trace_place place = {0, 0, 0, {0.6, 0.8}};
    hatch_trace_turn(&place, 1);
    ck_assert(place.heading[0] == -0.8 && place.heading[1] == 0.6);
    hatch_trace_turn(&place, -1);
    ck_assert(place.heading[0] == 0.6 && place.heading[1] == 0.8);
}
END_TEST

/* A spiral up a tube: along the field, the height rises with the sine of the angle. */
START_TEST(a_walk_along_the_field_is_a_helix)
{
    struct field_case tube = case_of_shape(HATCH_SHAPE_CYLINDER, 4000, 0);
    set_direction(&tube, 0, 1, 0);
    struct hatch_trace_ground ground = lay_out(&tube, -PI / 3, 0.7);
    for (uint32_t f = 0; f < tube.surface.face_count; f += 101) {
        struct hatch_trace_place place = middle_of(&ground, f, 0);
        double from[3], to[3];
        ck_assert(hatch_trace_direction(&ground, &place, place.heading));
        place_at(&ground, &place, from);
        double walked = walk(&ground, &place, 20, HATCH_TRACE_ALONG);
        place_at(&ground, &place, to);
        ck_assert_double_eq_tol(fabs(to[1] - from[1]), walked / 2, 0.01 * walked + 0.05);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("trace ground");
    TCase *tests = tcase_create("ground");
    tcase_add_checked_fixture(tests, begin, end);
    tcase_add_test(tests, successive_faces_are_near);
    tcase_add_test(tests, a_face_keeps_its_form);
    tcase_add_test(tests, only_larger_angles_are_hard);
    tcase_add_test(tests, the_direction_is_the_field_turned);
    tcase_add_test(tests, a_singularity_has_no_direction);
    tcase_add_test(tests, large_faces_have_directions_next_to_singularities);
    tcase_add_test(tests, a_walk_over_a_plane_is_straight);
    tcase_add_test(tests, a_walk_around_a_cube_closes);
    tcase_add_test(tests, headings_keep_their_angle_to_edges);
    tcase_add_test(tests, slanted_strokes_end_where_the_outside_changes);
    tcase_add_test(tests, a_turn_is_a_right_angle);
    tcase_add_test(tests, a_walk_along_the_field_is_a_helix);
    suite_add_tcase(suite, tests);
    return suite;
}

HATCH_TEST_MAIN(suite)
