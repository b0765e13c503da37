/* The tables of a scene file, in the order of its header; tools read this list too. */
#ifndef TABLE_LIST_H
#define TABLE_LIST_H

#include "compiler.h"

/* TABLE(name, type): entries of a struct type. BLOCK(name): bytes, a multiple of 8. */
#define TABLE_LIST(TABLE, BLOCK) \
    TABLE(textures, scene_texture) \
    TABLE(materials, scene_material) \
    TABLE(objects, scene_object) \
    TABLE(vertices, vertex) \
    TABLE(poses, scene_pose) \
    TABLE(points, scene_point) \
    TABLE(normals, scene_normal) \
    TABLE(corners, scene_corner) \
    TABLE(faces, scene_face) \
    TABLE(meshes, scene_mesh) \
    TABLE(instances, scene_instance) \
    TABLE(views, scene_view) \
    TABLE(views16, scene_view16) \
    TABLE(nodes, scene_node) \
    TABLE(slots, scene_slot) \
    TABLE(units, scene_unit) \
    TABLE(lists, scene_list) \
    TABLE(words, n64_word) \
    BLOCK(dram) \
    TABLE(glide_units, scene_glide_unit) \
    TABLE(pipes, scene_pipe) \
    BLOCK(glide_memory)

#endif
