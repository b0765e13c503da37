"""The order of test files."""

#: The files that take most processor time, longest first, so that neither process ends long before
#: the other.
LONGEST = """accuracy/bench accuracy/hard_cases kernels/kernels product/scene_program product/repeatable polygon/renderers
    polygon/runs mesh/once mesh/meshes screen/demo accuracy/fuzz polygon/hosts accuracy/bounds
    screen/show guest/shared_pages guest/guest_input polygon/polygons glide/tiles glide/polygons
    n64/polygons polygon/lowering polygon/wide glide/scenes n64/vectors n64/scenes compiler/run
    accuracy/properties accuracy/italian_methods compiler/settings product/report
    mesh/hard_meshes accuracy/accuracy polygon/mappers product/disk screen/display product/sdk
    n64/modes glide/adds polygon/borders product/pages kernels/kernel_checker glide/modes
    accuracy/polys accuracy/scene_errors n64/decode glide/downloads n64/model n64/core
    guest/emulator guest/ntsc guest/endings""".split()
