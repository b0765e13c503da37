/* A mesh's tables, in the scene file's format. */
#ifndef MESH_RECORDS_H
#define MESH_RECORDS_H

#include "compiler.h"

enum mesh_constants {
    MESH_COUNT_MAX = 4096,      /* points, normals and faces of a mesh, each */
    MESH_CORNERS_MAX = 32,      /* of a face: clipping adds some */
    MESH_REACH = 2048,          /* largest coordinate of a mesh's points */
    MESH_UNIT16 = 16383,        /* largest coordinate of a mesh's points in 16 bits */
    MESH_FACTOR16 = 16384,      /* largest factor of a view in 16 bits */
    MESH_SHIFT16 = 31,          /* largest of its shifts */
    MESH_AWAY = 10240           /* distance of its origin from the camera on each axis, excluded:
                                   every point is less than 16,384 away */
};

/* A mesh's points, 16.16, within MESH_REACH. */
struct scene_point {
    fix16 x, y, z;
};

/* Of unit length, 2.14, each coordinate from -1 to 1. */
struct scene_normal {
    int16 x, y, z, spare;
};

/* s and t as in a vertex. */
struct scene_corner {
    uint16 point, normal;       /* of the mesh; the normal is used by instances with flags */
    fix16 s, t;
};

/* A convex polygon. It is flat, and its corners' s, t and shades are planes over it. It is visible
   from the side of its normal x, y, z (2.30, -1 to 1): where normal * eye is more than distance
   (16.16). Zeros and a distance of -1: from both sides. */
struct scene_face {
    int32 x, y, z;
    fix16 distance;
    uint32 corner, corners;     /* first of the mesh's, number: 3 to MESH_CORNERS_MAX */
};

/* First entries and numbers of entries in the tables above; all but corners at most
   MESH_COUNT_MAX. */
struct scene_mesh {
    uint32 point, points, normal, normals, corner, corners, face, faces;
};

/* Values of corners that are made for each frame, in instance.flags. */
enum mesh_flags {
    MESH_ENVIRONMENT = 1,       /* s and t, from normals */
    MESH_LIT = 2,               /* shade, from normals */
    MESH_FOG = 4,               /* shade, from depths: not with MESH_LIT */
    MESH_FLAGS = 8
};

/* A node of a tree that says in which order faces are drawn. The nodes of its front, the half space
   where normal * place is distance or more, follow it; those of its back follow these. Its own faces
   are in its plane, or if it has no other nodes, in an order that is right from everywhere. A tree's
   slots are numbered from 0 on, node after node. */
struct scene_node {
    int32 x, y, z;              /* 2.30, -1 to 1 */
    fix16 distance;
    uint32 front, back;         /* nodes */
    uint32 slot, slots;         /* first of its faces' slots, number */
};

/* The place of a face in its tree. */
struct scene_slot {
    uint32 slot;
};

/* From a mesh's space to the camera's: x to the right and y down, both times focal length / guard
   pixels, z the depth. Each is the sum of three products and x0, y0 or z0, rounded to the nearest
   1/65536. Screen x = middle + guard pixels * x / z. */
struct scene_view {
    int32 xx, xy, xz, yx, yy, yz, zx, zy, zz;   /* 2.30, -1 to 1 */
    fix16 x0, y0, z0;
    fix16 eye_x, eye_y, eye_z;                  /* the camera's position in the mesh's space */
    int16 s_x, s_y, s_z;        /* 128 + normal * s_ is s of an environment; 9.7 */
    int16 t_x, t_y, t_z;
    int16 light_x, light_y, light_z;            /* dark + normal * light_ is a shade */
    int16 spare;
};

/* The same from 16-bit points (struct mesh_point16) to places on the screen: three sums of products
   and a move, modulo 2^32. The depth is w's sum >> divisor_shift; it is one of 16.16 once shifted
   left by depth_shift. The sums of x and y divided by it are 1/16 pixel, the floor is the nearest. A
   move holds what a sum is rounded by, less the product of its row's first two factors
   (mesh_transform). The tools write it where every point is beyond the near plane and those on the
   screen are then within 1/32 pixel of their exact places: tools/tmap/compiler/views16.py. */
struct scene_view16 {
    int32 w_move;
    int16 wx, wy, wz, divisor_shift;
    int32 x_move;
    int16 xx, xy, xz, depth_shift;
    int32 y_move;
    int16 yx, yy, yz, seen_shift;
    int16 eye_x, eye_y, eye_z;  /* the camera's position in the mesh, 16.16 >> 14 - seen_shift:
                                   products with a normal's upper words >> seen_shift are 16.16 */
    int16 is_used;              /* 0: this frame has none */
};

#endif
