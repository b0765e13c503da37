"""The order of test files."""

#: The files that take most processor time, longest first, so that neither process ends long before
#: the other.
LONGEST = """accuracy/bench kernels/kernels screen/demo accuracy/fuzz accuracy/hard_cases mesh/meshes product/report
    product/scene_program polygon/hosts accuracy/accuracy screen/show mesh/once screen/display product/repeatable
    polygon/renderers polygon/runs accuracy/bounds guest/guest_input polygon/polygons glide/tiles glide/polygons
    n64/polygons polygon/lowering polygon/wide glide/scenes n64/vectors n64/scenes compiler/run
    accuracy/properties accuracy/italian_methods compiler/settings mesh/hard_meshes guest/shared_pages
    guest/endings polygon/mappers product/disk product/sdk n64/modes glide/adds polygon/borders product/pages
    kernels/kernel_checker glide/modes accuracy/polys accuracy/scene_errors n64/decode glide/downloads n64/model
    n64/core guest/emulator guest/ntsc""".split()
