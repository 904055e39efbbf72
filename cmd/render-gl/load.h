/* Reads what a picture is made of from files. Where no status is returned they die with one line on what
 * is wrong. */
#ifndef RENDER_LOAD_H
#define RENDER_LOAD_H

#include "cmd.h"
#include "mesh/scene.h"

/* A glTF with its companions, or one mesh; path NULL is standard input. */
void load_scene(struct cmd_args *args, const char *path, struct hatch_scene *scene);

/* HATCH_BAD_INPUT when a mesh has no texture coordinates, naming the way to some. */
enum hatch_status load_check_texcoords(const struct hatch_scene *scene, struct hatch_err *err)
    HATCH_MUST_USE;

#endif
