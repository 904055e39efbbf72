#include <climits>
#include <cmath>
#include <exception>
#include <new>
#include <vector>

/* With assertions, OpenMesh compares the name of a property's type at each access to it. */
#ifndef NDEBUG
#define NDEBUG
#endif
/* gcc warns of vectors that OpenMesh resizes before it sets their values. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

/* This C header has a struct and a function of one name (hatch_arena_mark). In C++, -Wshadow warns that the function
 * hides the struct's constructor. */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
extern "C" {
#include "io/openmesh/openmesh.h"
}
#pragma GCC diagnostic pop

namespace
{

struct Traits : OpenMesh::DefaultTraits {
    typedef OpenMesh::Vec3d Point;
    typedef OpenMesh::Vec3d Normal;
};

/* Largest number of edges at a vertex while a mesh is decimated: the time of a collapse grows with the square of their
 * number. On flat parts, where all collapses are as good, points would otherwise collapse into a few. */
const unsigned valence_max = 32;

const unsigned edges_max = valence_max + 4; /* of both vertices of a collapse together */

typedef OpenMesh::TriMesh_ArrayKernelT<Traits> Base;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

/* Returns the third vertex of a halfedge's face; an invalid one at a boundary. */
VertexHandle apex(const Base &mesh, HalfedgeHandle halfedge)
{
    return mesh.is_boundary(halfedge) ? VertexHandle() : mesh.to_vertex_handle(mesh.next_halfedge_handle(halfedge));
}

/* Returns whether the other two edges of a halfedge's face are boundaries. */
bool is_ear(const Base &mesh, HalfedgeHandle halfedge)
{
    if (mesh.is_boundary(halfedge))
        return false;
    HalfedgeHandle next = mesh.next_halfedge_handle(halfedge);
    return mesh.is_boundary(mesh.opposite_halfedge_handle(next)) &&
           mesh.is_boundary(mesh.opposite_halfedge_handle(mesh.next_halfedge_handle(next)));
}

/* Finds the vertices around a vertex. Returns their number, most + 1 if there are more than `most`. */
unsigned find_ring(const Base &mesh, VertexHandle centre, unsigned most, VertexHandle *ring)
{
    HalfedgeHandle first = mesh.halfedge_handle(centre), at = first;
    unsigned count = 0;
    do {
        if (count == most)
            return most + 1;
        ring[count++] = mesh.to_vertex_handle(at);
        at = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(at));
    } while (at != first);
    return count;
}

/* Returns whether two vertices have no neighbours in common but left and right, and no more than edges_max edges. */
bool rings_meet_only_at(const Base &mesh, VertexHandle a, VertexHandle b, VertexHandle left, VertexHandle right)
{
    VertexHandle ring_a[edges_max], ring_b[edges_max];
    unsigned count_a = find_ring(mesh, a, edges_max, ring_a);
    unsigned count_b = count_a > edges_max ? 0 : find_ring(mesh, b, edges_max - count_a, ring_b);
    if (count_a + count_b > edges_max)
        return false;
    for (unsigned i = 0; i < count_a; i++)
        for (unsigned k = 0; k < count_b; k++)
            if (ring_a[i] == ring_b[k] && ring_a[i] != left && ring_a[i] != right)
                return false;
    return true;
}

/* OpenMesh's mesh, with a faster test of collapses, which takes most of the time of decimation. */
class Mesh : public Base
{
  public:
    /* Returns whether the surface remains one, and valence_max is kept to, when a halfedge's first vertex moves to its
     * second. Hides OpenMesh's method, which marks vertices through checked properties and takes ten times as long. */
    bool is_collapse_ok(HalfedgeHandle halfedge)
    {
        HalfedgeHandle back = opposite_halfedge_handle(halfedge);
        VertexHandle from = to_vertex_handle(back), to = to_vertex_handle(halfedge);
        VertexHandle left = apex(*this, halfedge), right = apex(*this, back);
        if (status(edge_handle(halfedge)).deleted() || left == right || is_ear(*this, halfedge) || is_ear(*this, back))
            return false;
        bool inside = !is_boundary(halfedge) && !is_boundary(back);
        if (inside && is_boundary(from) && is_boundary(to))
            return false;
        return rings_meet_only_at(*this, from, to, left, right);
    }
};

/* Centre and size of the mesh's bounding box. Decimation works on normalised positions: quadrics lose
 * precision far from the origin and at extreme sizes. */
struct Frame {
    double centre[3], size;
};

Frame frame_of(const struct hatch_mesh *mesh)
{
    float low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    Frame frame = {{0, 0, 0}, 0};
    hatch_mesh_bounds(mesh, low, high);
    for (int k = 0; k < 3; k++) {
        double a = static_cast<double>(low[k]), b = static_cast<double>(high[k]);
        frame.centre[k] = (a + b) / 2;
        frame.size = std::fmax(frame.size, b - a);
    }
    frame.size = frame.size > 0 ? frame.size : 1;
    return frame;
}

void add_points(const struct hatch_mesh *mesh, const Frame &frame, const uint32_t *point, uint32_t count, Mesh *to)
{
    const float *positions = mesh->attributes[0].data;
    uint32_t added = 0;
    for (uint32_t v = 0; v < mesh->vertex_count && added < count; v++) {
        if (point[v] != added)
            continue; /* only the first vertex at a position becomes a point */
        double p[3];
        for (size_t k = 0; k < 3; k++)
            p[k] = (static_cast<double>(positions[v * size_t{3} + k]) - frame.centre[k]) / frame.size;
        to->add_vertex(Mesh::Point(p[0], p[1], p[2]));
        added++;
    }
}

/* Returns the largest number of faces at a vertex to begin with; where there are more, the mesh is cut. The time that a
 * vertex costs grows with the cube of its faces. The poles of a sphere are no reason to cut, fans of thousands are. */
unsigned faces_per_vertex_max(const struct hatch_mesh *mesh, const uint32_t *point, uint32_t point_count)
{
    std::vector<double> faces(point_count);
    double cost = 0;
    for (size_t i = 0; i < size_t{3} * mesh->face_count; i++)
        faces[point[mesh->indices[i]]]++;
    for (double count : faces)
        cost += count * count * count;
    return cost > 1e8 + 2000.0 * mesh->face_count ? valence_max : UINT_MAX;
}

/* The vertices that stand for points. Where more faces meet at a point than one vertex may have, further vertices are
 * made for it. */
struct Hubs {
    Mesh *mesh;
    unsigned most;                        /* faces at a vertex */
    std::vector<Mesh::VertexHandle> last; /* per point: its latest vertex */
    std::vector<unsigned> faces;          /* per point: faces at this vertex */

    Hubs(Mesh *to, unsigned limit) : mesh(to), most(limit), faces(to->n_vertices())
    {
        for (const auto &vertex : to->vertices())
            last.push_back(vertex);
    }

    Mesh::VertexHandle take(uint32_t point)
    {
        if (faces[point]++ == most) {
            Mesh::Point at = mesh->point(last[point]);
            last[point] = mesh->add_vertex(at);
            faces[point] = 1;
        }
        return last[point];
    }
};

uint32_t add_faces(const struct hatch_mesh *mesh, const uint32_t *point, unsigned faces_max, Mesh *to)
{
    Hubs hubs(to, faces_max);
    uint32_t left_out = 0;
    omerr().disable(); /* OpenMesh prints each refused face, but a library must not print */
    for (uint32_t f = 0; f < mesh->face_count; f++) {
        Mesh::VertexHandle corner[3];
        for (size_t c = 0; c < 3; c++)
            corner[c] = hubs.take(point[mesh->indices[f * size_t{3} + c]]);
        bool distinct = corner[0] != corner[1] && corner[1] != corner[2] && corner[2] != corner[0];
        bool added = distinct && to->add_face(corner[0], corner[1], corner[2]).is_valid();
        left_out += !added;
    }
    omerr().enable();
    return left_out;
}

/* Makes OpenMesh's mesh.
 *   cut  cut it at points where too many faces meet to decimate it */
enum hatch_status load(const struct hatch_mesh *mesh, const Frame &frame, struct hatch_arena *scratch, bool cut,
                       Mesh *to, uint32_t *left_out, struct hatch_err *err)
{
    uint32_t count;
    if (mesh->vertex_count > INT32_MAX / 3 || mesh->face_count > INT32_MAX / 3)
        return hatch_fail(err, HATCH_LIMIT, "%u faces are too many for OpenMesh", mesh->face_count);
    uint32_t *point = HATCH_NEW(scratch, uint32_t, mesh->vertex_count, err);
    if (!point)
        return HATCH_LIMIT;
    HATCH_TRY(hatch_mesh_weld(mesh, scratch, point, &count, err));
    add_points(mesh, frame, point, count, to);
    *left_out = add_faces(mesh, point, cut ? faces_per_vertex_max(mesh, point, count) : UINT_MAX, to);
    to->request_face_status();
    to->request_edge_status();
    to->request_vertex_status();
    to->request_halfedge_status();
    to->delete_isolated_vertices();
    to->garbage_collection();
    if (to->n_faces() == 0)
        return hatch_fail(err, HATCH_BAD_INPUT, "no face remains: all are degenerate or non-manifold");
    return HATCH_OK;
}

void reduce(Mesh *mesh, uint32_t face_count)
{
    typedef OpenMesh::Decimater::DecimaterT<Mesh> Decimater;
    typedef OpenMesh::Decimater::ModQuadricT<Mesh>::Handle Quadric;
    mesh->request_face_normals();
    mesh->update_face_normals();
    Decimater decimater(*mesh);
    Quadric quadric;
    decimater.add(quadric);
    decimater.module(quadric).unset_max_err();
    decimater.initialize();
    decimater.decimate_to_faces(0, face_count);
    mesh->garbage_collection();
}

enum hatch_status store(const Mesh &from, const Frame &frame, struct hatch_arena *arena, struct hatch_mesh *out,
                        struct hatch_err *err)
{
    struct hatch_mesh made;
    HATCH_TRY(hatch_mesh_make(arena, static_cast<uint32_t>(from.n_vertices()), static_cast<uint32_t>(from.n_faces()),
                              &made, err));
    float *position = made.attributes[0].data;
    for (const auto &vertex : from.vertices())
        for (unsigned k = 0; k < 3; k++)
            *position++ = static_cast<float>(from.point(vertex)[k] * frame.size + frame.centre[k]);
    uint32_t *index = made.indices;
    for (const auto &face : from.faces())
        for (auto corner = from.cfv_ccwbegin(face); corner != from.cfv_ccwend(face); ++corner)
            *index++ = static_cast<uint32_t>(corner->idx());
    *out = made;
    return HATCH_OK;
}

uint32_t count_boundary_loops(const Mesh &mesh)
{
    std::vector<bool> seen(mesh.n_halfedges());
    uint32_t loops = 0;
    for (const auto &start : mesh.halfedges()) {
        if (!mesh.is_boundary(start) || seen[static_cast<size_t>(start.idx())])
            continue;
        loops++;
        Mesh::HalfedgeHandle at = start;
        do {
            seen[static_cast<size_t>(at.idx())] = true;
            at = mesh.next_halfedge_handle(at);
        } while (at != start);
    }
    return loops;
}

/* Runs a body that may throw, and rewinds scratch. */
template <typename Body> enum hatch_status guarded(struct hatch_arena *scratch, struct hatch_err *err, Body body)
{
    struct hatch_arena_mark mark = hatch_arena_mark(scratch);
    enum hatch_status status;
    try {
        status = body();
    } catch (const std::bad_alloc &) {
        status = hatch_fail(err, HATCH_LIMIT, "out of memory while simplifying a mesh");
    } catch (const std::exception &e) {
        status = hatch_fail_quoting(err, HATCH_BAD_INPUT, e.what(), "the mesh cannot be simplified");
    }
    hatch_arena_rewind(scratch, mark);
    return status;
}

} // namespace

extern "C" enum hatch_status hatch_mesh_decimate(const struct hatch_mesh *mesh, uint32_t face_count,
                                                 struct hatch_arena *arena, struct hatch_arena *scratch,
                                                 struct hatch_mesh *out, uint32_t *left_out, struct hatch_err *err)
{
    return guarded(scratch, err, [&]() {
        Mesh work;
        uint32_t refused;
        Frame frame = frame_of(mesh);
        HATCH_TRY(load(mesh, frame, scratch, true, &work, &refused, err));
        if (work.n_faces() > face_count)
            reduce(&work, face_count);
        HATCH_TRY(store(work, frame, arena, out, err));
        if (left_out)
            *left_out = refused;
        return HATCH_OK;
    });
}

extern "C" enum hatch_status hatch_mesh_connectivity(const struct hatch_mesh *mesh, struct hatch_arena *scratch,
                                                     struct hatch_connectivity *connectivity, struct hatch_err *err)
{
    return guarded(scratch, err, [&]() {
        Mesh work;
        uint32_t refused;
        HATCH_TRY(load(mesh, frame_of(mesh), scratch, false, &work, &refused, err));
        *connectivity = {static_cast<uint32_t>(work.n_vertices()), static_cast<uint32_t>(work.n_edges()),
                         static_cast<uint32_t>(work.n_faces()), count_boundary_loops(work), refused};
        return HATCH_OK;
    });
}
