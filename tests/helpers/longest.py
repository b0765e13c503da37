"""The order of test files."""

#: The files that take most processor time, longest first, so that neither process ends long before
#: the other.
LONGEST = """accuracy/bench kernels/kernels screen/demo accuracy/fuzz mesh/meshes accuracy/hard_cases mesh/once
    polygon/hosts screen/hold product/disk screen/show product/report accuracy/accuracy product/scene_program
    mesh/depth_fills accuracy/properties mesh/fog screen/demo_window screen/display guest/untimed
    product/repeatable mesh/hard_meshes guest/emulator polygon/borders product/profile polygon/lowering
    accuracy/italian_methods accuracy/fit product/sdk guest/endings guest/guest_input polygon/polygons
    polygon/runs compiler/run mesh/orders glide/tiles product/pages guest/second_processor accuracy/bounds
    accuracy/orders n64/polygons guest/memory compiler/scene polygon/wide polygon/planar polygon/mappers mesh/near
    mesh/trees n64/vectors glide/scenes compiler/settings mesh/bodies glide/polygons mutants/mutants mipmap/levels
    mesh/space mesh/visible accuracy/scene_errors compiler/pixel_sizes n64/decode mesh/grids guest/shared_pages
    guest/ntsc accuracy/polys n64/scenes polygon/many_maps""".split()
