/* Numbers that C and GLSL share: uniform blocks, texture units, uniform locations, vertex attributes. gpu/embed.sh
 * copies the #define lines in front of every shader stage, so each must be plain: a name and a number. */
#ifndef RENDER_GPU_BINDINGS_H
#define RENDER_GPU_BINDINGS_H

/* Uniform blocks */
#define BLOCK_FRAME 0
#define BLOCK_TECHNIQUE 1 /* free for the technique in use */
#define BLOCK_SHADOWS 2
#define BLOCK_HALOES 3

/* Texture units */
#define UNIT_TONES 0 /* the asset that strokes are read from; in full-screen passes the texture to read */
#define UNIT_SOURCE 1
#define UNIT_SHADOW_TEXELS 2
#define UNIT_BASE 3
#define UNIT_TECHNIQUE 4 /* five units, 4 .. 8, free for the technique in use */
#define UNIT_NORMALS 9
#define UNIT_PIECES 10 /* three units, 10 .. 12: vertices, surface derivatives along u and v, repeats */
#define UNIT_SHADOWS 13
#define UNIT_HALO_DEPTHS 14
#define UNIT_HALO_CELLS 15
#define UNIT_HALO_BLOCKS 16
#define UNIT_SOLIDS 17    /* eight units, 17 .. 24 */
#define UNIT_CHARTS 25    /* of pieces: numbers of charts */
#define UNIT_MAGNIFIED 26 /* pixels per texel of the map whose strokes are fitted */

/* Storage buffers of compute stages */
#define STORAGE_VERTICES 0 /* struct scene_vertex, as single floats */
#define STORAGE_PLACED 1
#define STORAGE_POINTS 2
#define STORAGE_RIBBON 3
#define STORAGE_FRAGMENTS 4
#define STORAGE_SLOTS 5
#define STORAGE_SORTED 6
#define STORAGE_MISSED 7
#define STORAGE_DRAWN 1 /* these two of fitted strokes, which have neither STORAGE_PLACED nor STORAGE_POINTS */
#define STORAGE_ORDER 2

/* Words per row of a texture of lists (assets/strokes.c), as a power of two */
#define LIST_ROW_BITS 13

/* Points of a fitted stroke's ribbon */
#define RIBBON_POINTS 17

/* Images that compute stages write */
#define IMAGE_OUTPUT 0

/* Uniforms of a drawn item */
#define UNIFORM_UNIT_FROM_MESH 0
#define UNIFORM_NORMAL_FROM_MESH 1
#define UNIFORM_SIDE 3
#define UNIFORM_PASS 4
#define UNIFORM_BASE 5
#define UNIFORM_NORMAL_STRENGTH 6
#define UNIFORM_LAYER 8
#define UNIFORM_COUNT 9
#define UNIFORM_LIFT 10
#define UNIFORM_INK 11
#define UNIFORM_DENSEST 12
#define UNIFORM_ITEM 13 /* index of the item */
#define UNIFORM_OVERDRAW 14
#define UNIFORM_BRUSH 15 /* length of the brush's stroke in pixels; mean of its grain */
#define UNIFORM_THINNEST 16
#define UNIFORM_MARGIN 23    /* pixels by which fragments are gathered beyond the frame's tile */
#define UNIFORM_REST 17      /* place of an item in solid textures: offset, and units of a mesh's length */
#define UNIFORM_REST_LOG 18  /* binary logarithm of a unit's length in the unit scene */
#define UNIFORM_REST_AXES 30 /* rows: the axes of solid textures in coordinates of the mesh */
#define UNIFORM_DEPTHS 31    /* whether depths of the surfaces can be read */
#define UNIFORM_MATERIAL 19  /* index of the item's material */
#define UNIFORM_PROFILE 32   /* BRUSH_PROFILE locations */
#define BRUSH_PROFILE 17
#define UNIFORM_CLIP_FROM_CAMERA 20
#define UNIFORM_PIECES 21
#define UNIFORM_TINT 22 /* colour of the item's material; white where colours are not drawn */

/* Uniforms of a pass that draws no items */
#define UNIFORM_A 0
#define UNIFORM_B 1
#define UNIFORM_C 2
#define UNIFORM_MARK_WIDTH 8
#define UNIFORM_LINE_SAMPLES 24 /* these three beside the uniforms of an item, which lights need */
#define UNIFORM_LINE_PLACE 25   /* four vectors, 25 .. 28 */
#define UNIFORM_LINE_BRUSH 29

/* Vertex attributes of an item */
#define ATTRIBUTE_POSITION 0
#define ATTRIBUTE_NORMAL 1
#define ATTRIBUTE_TEXCOORD 2
#define ATTRIBUTE_BASE_TEXCOORD 3
#define ATTRIBUTE_REPEAT 4
#define ATTRIBUTE_PATCH 5
#define ATTRIBUTE_ALONG_U 6
#define ATTRIBUTE_ALONG_V 7
#define ATTRIBUTE_TANGENT 8
#define ATTRIBUTE_NORMAL_TEXCOORD 9
#define ATTRIBUTE_CHART 10
#define ATTRIBUTE_REST 11 /* position in the undeformed mesh */

/* Vertex attributes of overlays, per instance */
#define ATTRIBUTE_LINE_ENDS 0
#define ATTRIBUTE_LINE_DEPTH 1
#define ATTRIBUTE_LINE_BRUSH 2
#define ATTRIBUTE_MARK_MIDDLE 0
#define ATTRIBUTE_MARK_HALF 1
#define ATTRIBUTE_MARK_CONFIDENCE 2

/* Vertex attribute of points that stand for fragments of strokes */
#define ATTRIBUTE_FRAGMENT 0

/* Vertex attributes of pieces, into which faces near the eye are cut (near/near.h) */
#define ATTRIBUTE_PLACE 0
#define ATTRIBUTE_FROM 1
#define ATTRIBUTE_WEIGHT 2
#define ATTRIBUTE_CORNER 3
#define ATTRIBUTE_ORIGIN_U 4
#define ATTRIBUTE_ORIGIN_V 5
#define ATTRIBUTE_ORIGIN_W 6

#endif
