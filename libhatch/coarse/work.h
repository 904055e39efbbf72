/* Private to this module: the mesh while it is made coarser. A point is a position; a wedge is a vertex of one of the
 * parts, which stands for all vertices of the part that equal it. */
#ifndef HATCH_COARSE_WORK_H
#define HATCH_COARSE_WORK_H

#include "coarse/coarse.h"
#include "coarse/queue.h"
#include "mesh/nearest/nearest.h"

#define HATCH_COARSE_NONE UINT32_MAX
#define HATCH_COARSE_RING_MAX 64u /* faces at a point that may collapse, or be collapsed onto */

/* The sum of squared distances from planes, as the upper half of a symmetric matrix of 4×4, and of their weights. */
struct hatch_coarse_quadric {
    double terms[10], weight;
};

/* A kind of attribute that a sample compares with the surface. */
enum hatch_coarse_check { HATCH_COARSE_TEXCOORD, HATCH_COARSE_COLOR, HATCH_COARSE_WEIGHTS, HATCH_COARSE_MORPH };

struct hatch_coarse_attribute {
    enum hatch_coarse_check check;
    uint32_t components;
    const float *data, *joints; /* joints: of WEIGHTS */
    float *scale; /* 3 per vertex of the part, TEXCOORD: factors of u u, 2 u v and v v in the square of the distance on
                     the surface, in mesh units, of texture coordinates that differ by u, v */
};

#define HATCH_COARSE_CHECKS_MAX HATCH_MESH_ATTRIBUTES_MAX

struct hatch_coarse_checks {
    uint32_t count;
    struct hatch_coarse_attribute attributes[HATCH_COARSE_CHECKS_MAX];
    const float *normals; /* 3 per vertex of the part; NULL: it has none */
};

struct hatch_coarse_work {
    const struct hatch_coarse_part *parts;
    uint32_t part_count;
    uint32_t *first_wedge, *first_face; /* per part and one more */
    uint32_t wedge_count, point_count, face_count;
    uint32_t *corner;          /* 3 per face: its wedges; the first is HATCH_COARSE_NONE for a face that is gone */
    uint32_t *point_of;        /* per wedge */
    double middle[3];          /* of the meshes */
    double *at;                /* 3 per point: positions relative to the middle */
    struct hatch_nearest full; /* the meshes as they were */
    double *tolerance;         /* per point */
    uint32_t *first;           /* per point: a corner there, or NONE */
    uint32_t *next;    /* per corner: the next at the same point, or NONE; corners of faces that are gone remain until
                          the list is read */
    uint32_t *part_of; /* per face */
    struct hatch_coarse_checks *checks;   /* per part */
    bool loose;                           /* collapses are judged by their costs, without samples */
    struct hatch_coarse_quadric *quadric; /* per point */
    /* Samples, each attached to the face that stands for it: the wedges of removed points, numbered as wedges, and the
     * centres of the full meshes' larger faces, numbered from wedge_count on. */
    uint32_t sample_count;
    uint32_t *first_sample; /* per face: a sample, or NONE */
    uint32_t *next_sample;  /* per sample */
    uint32_t *choice;       /* per sample: the face to which the collapse that is being judged would attach it */
    uint32_t *full_corner;  /* 3 per face: its wedges in the full meshes */
    uint32_t *center_of;    /* per centre: its face in the full meshes */
    uint32_t *line;         /* 2 per wedge: the border edge, two points, that stands for the sample; NONE: no border */
    /* Candidates. */
    struct hatch_coarse_queue queue; /* of points */
    uint32_t *target;                /* per point: the neighbour to collapse onto */
};

/* A neighbour of a point. */
struct hatch_coarse_spoke {
    uint32_t point;
    uint32_t here, there;     /* wedges of the first face at both ends of the edge */
    uint32_t leaving, coming; /* faces in which the edge runs from the point, and to it */
    bool border;              /* the edge is a border of the surface or of an attribute */
};

/* The faces and neighbours of a point. */
struct hatch_coarse_ring {
    uint32_t point, face_count, spoke_count, border_count;
    uint32_t faces[HATCH_COARSE_RING_MAX];
    uint32_t sides[HATCH_COARSE_RING_MAX]; /* per face: which corner the point is, 0 .. 2 */
    struct hatch_coarse_spoke spokes[2 * HATCH_COARSE_RING_MAX];
};

/* A collapse of a point onto a neighbour, which changes the faces of its ring. */
struct hatch_coarse_collapse {
    const struct hatch_coarse_ring *ring;
    const struct hatch_coarse_spoke *spoke;
    uint32_t other; /* the point at the other end of the border that is shortened; NONE: no border */
    uint32_t from[HATCH_COARSE_RING_MAX], to[HATCH_COARSE_RING_MAX]; /* wedges of the point, those that replace them */
    uint32_t pair_count;
    uint32_t kept[HATCH_COARSE_RING_MAX]; /* faces that remain, as indices of the ring's faces */
    uint32_t kept_count;
    double corners[HATCH_COARSE_RING_MAX][3][3]; /* per face that remains: its positions afterwards */
    uint32_t wedges[HATCH_COARSE_RING_MAX][3];   /* and its wedges */
};

/* Makes the lists from the parts; members of samples and candidates are allocated, too. */
enum hatch_status hatch_coarse_load(const struct hatch_coarse_part *parts, uint32_t part_count,
                                    struct hatch_arena *arena, struct hatch_arena *scratch,
                                    struct hatch_coarse_work *work, struct hatch_err *err) HATCH_MUST_USE;

/* Lists the attributes of each part that samples compare. */
enum hatch_status hatch_coarse_checks_make(struct hatch_coarse_work *work, struct hatch_arena *arena,
                                           struct hatch_err *err) HATCH_MUST_USE;

/* Returns the largest error of the attributes of a sample at a place on a face, squared, as a share of its tolerance.
 *   sample  a wedge of the face's part
 *   share   barycentric coordinates of the place */
double hatch_coarse_attribute_error(const struct hatch_coarse_work *work, uint32_t part, uint32_t sample,
                                    const uint32_t wedges[3], const double share[3]);

/* Finds the ring of a point. Returns false if it has no faces, or too many. */
bool hatch_coarse_ring_find(struct hatch_coarse_work *work, uint32_t point, struct hatch_coarse_ring *ring);

/* Prepares the collapse of a ring's point onto a neighbour. Returns false where the surface would no longer be one, a
 * face would turn over, or a wedge has none that could replace it.
 *   spoke  of a point on a border: one of its two border spokes */
bool hatch_coarse_collapse_find(struct hatch_coarse_work *work, const struct hatch_coarse_ring *ring,
                                const struct hatch_coarse_spoke *spoke, struct hatch_coarse_collapse *collapse);

/* Returns whether all samples stay within their tolerances of the new faces, and these within theirs of the full
 * meshes; fills choice with the samples' faces. */
bool hatch_coarse_judge(struct hatch_coarse_work *work, struct hatch_coarse_collapse *collapse);

/* Carries out a collapse that hatch_coarse_judge has allowed. */
void hatch_coarse_apply(struct hatch_coarse_work *work, const struct hatch_coarse_collapse *collapse);

/* Adds the planes of all faces, and planes across borders, to the quadrics of their points. */
void hatch_coarse_quadrics_make(struct hatch_coarse_work *work);

/* Returns the cost of a collapse: the sum of squared distances in tolerances. */
double hatch_coarse_cost(const struct hatch_coarse_work *work, uint32_t point, uint32_t onto);

/* Returns whether a collapse moves the surface by at most the tolerance, by its cost, and keeps the faces' shapes. */
bool hatch_coarse_is_cheap(const struct hatch_coarse_work *work, const struct hatch_coarse_collapse *collapse);

static inline uint32_t hatch_coarse_corner_point(const struct hatch_coarse_work *work, uint32_t corner)
{
    return work->point_of[work->corner[corner]];
}

#endif
