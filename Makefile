# Builds the Amiga programs and runs the tools. GNU make 4.3 or later.

MAKEFLAGS += --no-builtin-rules --no-print-directory
.DELETE_ON_ERROR:
# What is made under the lock of `programs`, or beside it.
OUTER := help run show demo play scene-program fit bench accuracy polys profile report adf sdk fuzz check mutants test diff clean programs setup
.PHONY: $(OUTER) built FORCE

# vbcc where it is installed; make CC68K=gcc or CC68K=vbcc chooses.
CC68K ?= $(if $(shell command -v vbccm68k),vbcc,gcc)
ifeq ($(filter gcc vbcc,$(CC68K)),)
$(error CC68K is gcc or vbcc, not "$(CC68K)")
endif
# As they were given: $ in a file's name names no variable.
GIVEN := SCENE MACHINE FRAMES FPS SEED COUNT FAMILY A B
$(foreach name,$(GIVEN),$(eval override $(name) := $$(value $(name))))
override SCENE := $(if $(SCENE),$(SCENE),tests/scenes/default.toml)
export $(GIVEN)

PYTHON := PYTHONPATH=tools .deps/venv/bin/python
VASM := scripts/vasm
GCC := m68k-linux-gnu-gcc
LD := m68k-linux-gnu-ld
VASM_FLAGS := -quiet -m68020 -Felf
ASM_FLAGS := $(VASM_FLAGS) -Isrc68k/include -Ibuild/gen
# There is no memset for it to call.
GCC_FLAGS := -std=c99 -pedantic -Wall -Wextra -Werror -m68020 -msoft-float -O2 \
  -ffreestanding -fno-pic -fomit-frame-pointer -fleading-underscore \
  -ffunction-sections -fdata-sections -fno-tree-loop-distribute-patterns -Ic
# For what no frame's time depends on, and the walk over objects, which is as fast. Units' files: what is done once a state.
UNIT_STATE := n64/check n64/levels n64/load $(addprefix n64/polygons/,page plan rectangle stages yuv) \
  $(addprefix glide/polygons/,bands combining lines plan tile_store)
# Its polygons are as fast: little of this stays in the cache from one to the next.
UNIT_POLYGONS := glide/polygons/draw
SMALL_FLAGS := -Os -fno-tree-loop-im -fno-move-loop-invariants
# 172 (more optimizer passes would help) is nobody's fault. On top of the warnings
# that are on: 64 never assigned, 67 and 124 type defaults to int, 161 no
# declaration, 162 no prototype, 169 extern in a function, 174 no return.
VBCC_FLAGS := -c99 -O=23999 -cpu=68020 -quiet -Ic -warnings-as-errors \
  -dontwarn=172 -warn=64 -warn=67 -warn=124 -warn=161 -warn=162 -warn=169 -warn=174
DEBUG_FLAGS := $(filter-out -O2,$(GCC_FLAGS)) -O0 -g -fno-eliminate-unused-debug-types
LD_FLAGS := -q -z noexecstack --no-check-sections --gc-sections -T src68k/amiga/program.ld

HEADERS := $(sort $(shell find c -name '*.h'))
C_FILES := $(sort $(shell find c -name '*.c' -not -path 'c/programs/*'))
# Not c/programs/scene.c: tools/tmap/product/scene_program.py links it with a scene.
NAMES := $(filter-out scene,$(patsubst c/programs/%.c,%,$(sort $(wildcard c/programs/*.c))))
# Texture units last, beside their generated tables: passes and tables share lines of the cache by place.
ASM_ROOMS := amiga coverage depths edge math mesh polygon screen span triangle glide n64
ASM_FILES := $(foreach room,$(ASM_ROOMS),$(sort $(wildcard src68k/$(room)/*.s)))

# Objects of each compiler have their own folder, so that either can be chosen.
C_OUT := build/obj/$(CC68K)
ASM_OUT := build/obj/asm
C_OBJECTS := $(C_FILES:c/%.c=$(C_OUT)/%.o)
SCENE_OBJECT := $(C_OUT)/programs/scene.o
SMALL_OBJECTS := $(filter-out %/draw_faces.o %/draw_meshes.o %/time.o,$(filter $(C_OUT)/system/% $(C_OUT)/scene/% $(C_OUT)/frames/% \
  $(UNIT_STATE:%=$(C_OUT)/%.o) $(UNIT_POLYGONS:%=$(C_OUT)/%.o),$(C_OBJECTS))) $(SCENE_OBJECT)
MAIN_OBJECTS := $(NAMES:%=$(C_OUT)/programs/%.o) $(SCENE_OBJECT)
ASM_OBJECTS := $(ASM_FILES:src68k/%.s=$(ASM_OUT)/%.o)
UAE_OBJECT := $(ASM_OUT)/amiga/uae.o
# Tables and code that a tool of the same name writes.
WRITTEN := n64_weights glide_weights glide_logarithms cubic_fits
OBJECTS := $(filter-out $(UAE_OBJECT),$(ASM_OBJECTS)) $(WRITTEN:%=$(ASM_OUT)/gen/%.o) $(C_OBJECTS)
KERNEL_TABLE := $(ASM_OUT)/gen/kernel_table.o
OWNERS_TABLE := $(ASM_OUT)/gen/owners_table.o
LAYOUT_CHECK := $(C_OUT)/gen/layout_check.o

help:
	@echo 'make run [SCENE=FILE] [MACHINE=NAME] [FRAMES=N]   render a scene: build/run/NAME'
	@echo 'make show [SCENE=FILE] [MACHINE=NAME] [FPS=RATE]  play a scene in a window: space, cursor keys, G, escape'
	@echo 'make demo [PLAY=1] [MACHINE=NAME]                 the demo, for an Amiga: build/demo; PLAY=1: in a window'
	@echo 'make scene-program [SCENE=FILE] [MACHINE=NAME]    a program that draws one scene: build/scene/NAME'
	@echo 'make fit FPS=RATE [SCENE=FILE] [MACHINE=NAME]     the most exact settings that hold a rate: build/fit/NAME'
	@echo 'make profile [SCENE=FILE] [MACHINE=NAME]          where its cycles go: build/profile/NAME'
	@echo 'make bench [MACHINE=NAME]                         measure every kernel: build/bench'
	@echo 'make accuracy [MACHINE=NAME]                      error and cycles of all settings: build/accuracy'
	@echo 'make polys [MACHINE=NAME]                         polygons a second: build/polys'
	@echo 'make report                                       all figures and pictures in one page: build/report'
	@echo 'make play [SCENE=FILE] [FPS=RATE]                 a bootable disk that plays a scene: build/play/NAME.adf'
	@echo 'make adf                                          a bootable disk for real Amigas: build/adf'
	@echo 'make sdk                                          headers, objects, an example for other programs: build/sdk'
	@echo 'make fuzz [SEED=N] [COUNT=N] [FAMILY=perspective|n64|glide] random polygons against model and bounds'
	@echo 'make check                                        tests of what you changed, a sample of others: a minute'
	@echo 'make mutants                                      small wrong changes, each of which a test must notice'
	@echo 'make test                                         run all tests'
	@echo 'make diff A=DIR B=DIR                             compare two runs'
	@echo 'make programs [CC68K=gcc|vbcc]                    build the Amiga programs only'
	@echo 'make clean                                        remove build/'

run: programs
	@scripts/tmap run "$$SCENE" $${MACHINE:+--machine "$$MACHINE"} $${FRAMES:+--frames "$$FRAMES"} \
	  -o "build/run/$$(basename "$$SCENE" .toml)"

show: programs
	@scripts/tmap show "$$SCENE" $${MACHINE:+--machine "$$MACHINE"} $${FPS:+--fps "$$FPS"}

demo: programs
	@scripts/tmap demo -o build/demo $${PLAY:+--play} $${MACHINE:+--machine "$$MACHINE"}

scene-program: programs
	@scripts/tmap scene-program "$$SCENE" $${MACHINE:+--machine "$$MACHINE"}

profile: programs
	@scripts/tmap profile "$$SCENE" $${MACHINE:+--machine "$$MACHINE"} $${FRAMES:+--frames "$$FRAMES"}

fit: programs
	@test -n "$$FPS" || { echo 'make fit: say which rate: FPS=12.5' >&2; exit 2; }
	@scripts/tmap fit "$$SCENE" --fps "$$FPS" $${MACHINE:+--machine "$$MACHINE"}

bench: programs
	@scripts/tmap bench $${MACHINE:+--machine "$$MACHINE"} -o build/bench

accuracy: programs
	@scripts/tmap accuracy $${MACHINE:+--machine "$$MACHINE"} -o build/accuracy

polys: programs
	@scripts/tmap polys $${MACHINE:+--machine "$$MACHINE"} -o build/polys

report: programs
	@scripts/tmap report -o build/report

play: programs
	@scripts/tmap play "$$SCENE" $${MACHINE:+--machine "$$MACHINE"} $${FPS:+--fps "$$FPS"}

adf: programs
	@scripts/tmap adf

sdk: programs
	@scripts/tmap sdk

fuzz: programs
	@scripts/setup second
	@scripts/tmap fuzz $${SEED:+--seed "$$SEED"} $${COUNT:+--count "$$COUNT"} \
	  $${FAMILY:+--family "$$FAMILY"} $${MACHINE:+--machine "$$MACHINE"}

# Of two hundred processes of Python each would compile the tools again.
test check: export PYTHONDONTWRITEBYTECODE :=

# A file's tests share what they made, so they stay together; tests/conftest.py has the order.
# The second processor is compiled while the programs are.
test:
	@scripts/setup second & second=$$!; $(MAKE) programs && wait $$second && \
	  .deps/venv/bin/python -m pytest -q -n 2 --dist loadfile --no-loadscope-reorder tests

# A change's own tests, and a sample of the others.
check:
	@scripts/setup second & second=$$!; $(MAKE) programs && wait $$second && $(PYTHON) -m tests.helpers.check

# Half an hour; python -m tests.mutants --help has its options.
mutants:
	@scripts/setup second & second=$$!; $(MAKE) programs && wait $$second && $(PYTHON) -m tests.mutants

diff:
	@test -n "$$A" -a -n "$$B" || { echo 'make diff: say which: A=DIR B=DIR' >&2; exit 2; }
	@scripts/tmap diff "$$A" "$$B"

clean:
	@rm -rf build

# One build at a time: a second make waits here, and then reads what the first has made.
programs:
	@flock Makefile $(MAKE) $(if $(findstring jobserver,$(MAKEFLAGS)),,-j$(shell nproc)) built

built: $(NAMES:%=build/programs/%) build/programs/uae $(SCENE_OBJECT) | setup

# Everything that is built waits for this, and nothing is rebuilt for it.
setup:
	@scripts/setup

# Files that change only when what they say does: what they say is in $(TEXT).
KEEP = @mkdir -p $(@D); printf '%s\n' $(TEXT) | cmp -s - $@ || printf '%s\n' $(TEXT) >$@

build/obj/flags: TEXT = '$(ASM_FLAGS)' '$(GCC_FLAGS)' '$(SMALL_FLAGS)' '$(VBCC_FLAGS)' '$(LD_FLAGS)' '$(SMALL_OBJECTS)'
build/obj/flags: FORCE
	$(KEEP)

# The compiler is in these names: a program is linked anew when it changes.
build/obj/objects: TEXT = $(CC68K) $(OBJECTS)
build/obj/objects: FORCE
	$(KEEP)

build/gen/headers.c: TEXT = $(HEADERS:c/%='#include "%"')
build/gen/headers.c: FORCE
	$(KEEP)

# Assembly. The appended lines name included files as targets, as gcc -MP does: a
# file that is gone must not stop the build.
define ASSEMBLE
@mkdir -p $(@D)
@echo "vasm $<"
@$(VASM) $(ASM_FLAGS) -dependall=make -depfile $(@:.o=.d) -o $@ $<
@sed -n 's/^[^:]*: *//p' $(@:.o=.d) | tr -s ' ' '\n' | sed -n '2,$$s/$$/:/p' >$(@:.o=.d.new)
@cat $(@:.o=.d.new) >>$(@:.o=.d); rm $(@:.o=.d.new)
endef

$(ASM_OUT)/%.o: src68k/%.s build/obj/flags | setup build/gen/layout.i
	$(ASSEMBLE)

$(ASM_OUT)/gen/%.o: build/gen/%.s build/obj/flags | setup build/gen/layout.i
	$(ASSEMBLE)

# C
define COMPILE_gcc
@mkdir -p $(@D)
@echo "gcc $<"
@$(GCC) $(GCC_FLAGS) -MMD -MP -c -o $@ $<
endef

define COMPILE_vbcc
@mkdir -p $(@D)
@echo "vbcc $<"
@$(GCC) -std=c99 -ffreestanding -Ic -MM -MP -MT $@ -MF $(@:.o=.d) $<
@vbccm68k $(VBCC_FLAGS) -o=$(@:.o=.s) $<
@$(VASM) $(VASM_FLAGS) -o $@ $(@:.o=.s)
endef

$(SMALL_OBJECTS): GCC_FLAGS += $(SMALL_FLAGS)

$(C_OUT)/%.o: c/%.c build/obj/flags | setup
	$(COMPILE_$(CC68K))

$(C_OUT)/gen/%.o: build/gen/%.c build/obj/flags | setup
	$(COMPILE_$(CC68K))

# The structs of the headers, for assembly and host, out of the debug information.
build/gen/headers.o: build/gen/headers.c build/obj/flags | setup
	@$(GCC) $(DEBUG_FLAGS) -MMD -MP -c -o $@ $<

build/gen/layout.json build/gen/layout.i build/gen/layout_check.c &: build/gen/headers.o tools/tmap/build/layout.py
	@$(PYTHON) -m tmap.build.layout $< build/gen $(HEADERS:c/%=%)

build/gen/kernel_table.s build/gen/owners_table.s &: $(ASM_FILES) tools/tmap/build/contracts.py build/obj/objects | setup
	@$(PYTHON) -m tmap.build.contracts src68k build/gen

$(WRITTEN:%=build/gen/%.s): build/gen/%.s: tools/tmap/build/%.py | setup
	@mkdir -p $(@D)
	@$(PYTHON) -m tmap.build.$* $@

build/gen/n64_weights.s build/gen/glide_weights.s: tools/tmap/build/weights.py
build/gen/cubic_fits.s: tools/tmap/base/cubics.py

# Programs: $1 is the name, $2 its objects.
define PROGRAM
build/obj/$1.elf: $2 src68k/amiga/program.ld build/obj/objects build/obj/flags | setup
	@echo "link $$@"
	@$(LD) $(LD_FLAGS) -Map=build/obj/$1.link -o $$@ $2

build/programs/$1 build/programs/$1.map &: build/obj/$1.elf tools/tmap/build/hunk.py
	@mkdir -p build/programs
	@$(PYTHON) -m tmap.build.hunk $$< build/programs/$1
endef

$(foreach name,$(NAMES),$(eval $(call PROGRAM,$(name),$(C_OUT)/programs/$(name).o $(OBJECTS) \
  $(if $(filter bench,$(name)),$(KERNEL_TABLE)) $(if $(filter measure,$(name)),$(OWNERS_TABLE)))))
$(eval $(call PROGRAM,uae,$(UAE_OBJECT) $(ASM_OUT)/amiga/exact.o))
$(NAMES:%=build/obj/%.elf): $(LAYOUT_CHECK)

# Not without the lock: another make may be writing them.
ifneq ($(filter-out $(OUTER),$(MAKECMDGOALS)),)
-include $(patsubst %.o,%.d,$(MAIN_OBJECTS) $(OBJECTS) $(UAE_OBJECT) $(KERNEL_TABLE) $(OWNERS_TABLE) $(LAYOUT_CHECK) \
  build/gen/headers.o)
endif
