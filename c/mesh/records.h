/* A mesh's tables, as the scene file has them. */
#ifndef MESH_RECORDS_H
#define MESH_RECORDS_H

#include "compiler.h"

enum mesh_constants {
    MESH_COUNT_MAX = 4096,      /* points, normals and faces of a mesh, each */
    MESH_CORNERS_MAX = 32,      /* of a face: cutting adds some */
    MESH_REACH = 2048,          /* a mesh's points: farthest coordinate */
    MESH_AWAY = 10240           /* its origin from the camera, each axis: excluded, so that
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

/* s and t as a vertex has them. */
struct scene_corner {
    uint16 point, normal;       /* of the mesh; the normal counts where an instance has flags */
    fix16 s, t;
};

/* A convex polygon, a plane in space as its corners' s, t and shades are, seen from where its normal points: x, y, z (2.30, -1 to 1) times the
   eye is more than distance (16.16). Zeros and -1: from both sides. */
struct scene_face {
    int32 x, y, z;
    fix16 distance;
    uint32 corner, corners;     /* first of the mesh's, how many: 3 to MESH_CORNERS_MAX */
};

/* First entries of the tables above and how many: MESH_COUNT_MAX but for corners. */
struct scene_mesh {
    uint32 point, points, normal, normals, corner, corners, face, faces;
};

/* What comes from normals, in instance.flags. */
enum mesh_flags {
    MESH_ENVIRONMENT = 1,       /* s and t */
    MESH_LIT = 2,               /* shade */
    MESH_FLAGS = 4
};

/* From a mesh to the camera: x to the right and y down, both times the focal length over
   the guard's pixels, z the depth. Each is the sum of three products and x0, y0 or z0, rounded
   to the nearest 1/65536. Screen x = middle + guard pixels * x / z. */
struct scene_view {
    int32 xx, xy, xz, yx, yy, yz, zx, zy, zz;   /* 2.30, -1 to 1 */
    fix16 x0, y0, z0;
    fix16 eye_x, eye_y, eye_z;                  /* the camera's place in the mesh */
    int16 s_x, s_y, s_z;        /* 128 + normal * s_ is s of an environment; 9.7 */
    int16 t_x, t_y, t_z;
    int16 light_x, light_y, light_z;            /* dark + normal * light_ is a shade */
    int16 spare;
};

#endif
