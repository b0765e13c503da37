; Amiga system facts: library offsets, custom chip and CIA registers.
; Source: the public autodocs and the Hardware Reference Manual.

        include "routine.i"

; exec.library, and where its base is read
sys_base                equ     4
_LVOFindResident        equ     -96
_LVOSupervisor          equ     -30
_LVOForbid              equ     -132
_LVOPermit              equ     -138
_LVODisable             equ     -120
_LVOEnable              equ     -126
_LVOSetIntVector        equ     -162
_LVOAddIntServer        equ     -168
_LVORemIntServer        equ     -174
_LVOAllocMem            equ     -198
_LVOAllocAbs            equ     -204
_LVOFreeMem             equ     -210
_LVOAvailMem            equ     -216
_LVOFindTask            equ     -294
_LVOSetSignal           equ     -306
_LVOSignal              equ     -324
_LVOGetMsg              equ     -372
_LVOReplyMsg            equ     -378
_LVOWaitPort            equ     -384
_LVOCloseLibrary        equ     -414
_LVOOpenDevice          equ     -444
_LVOCloseDevice         equ     -450
_LVODoIO                equ     -456
_LVOOpenResource        equ     -498
_LVOTypeOfMem           equ     -534
_LVOOpenLibrary         equ     -552
_LVOCacheClearU         equ     -636
_LVOCreateIORequest     equ     -654
_LVODeleteIORequest     equ     -660
_LVOCreateMsgPort       equ     -666
_LVODeleteMsgPort       equ     -672

lib_Version             equ     20
lib_Revision            equ     22
AttnFlags               equ     296
MemList                 equ     322
ex_EClockFrequency      equ     568
AFB_68020               equ     1
tc_TrapCode             equ     50
rt_Init                 equ     22
pr_MsgPort              equ     92
pr_CIS                  equ     156
pr_COS                  equ     160
pr_CLI                  equ     172
pr_WindowPtr            equ     184
sm_ArgList              equ     36
wa_Lock                 equ     0

SIGBREAKF_CTRL_C        equ     $1000
ERROR_BREAK             equ     304

MEMB_CHIP               equ     1
MEMB_FAST               equ     2
MEMF_CHIP               equ     2
MEMF_FAST               equ     4
MEMF_CLEAR              equ     $10000
MEMF_LARGEST            equ     $20000
MEMF_TOTAL              equ     $80000
mh_Attributes           equ     14
mh_Lower                equ     20
mh_Upper                equ     24

; The head of a block that mem_alloc and mem_take get from exec.
BLOCK_SIZE              equ     4       ; after the address of the previous block
BLOCK_HEAD              equ     8

; Notes the block a0 of \1 bytes, which is freed at the program's end.
keep_block macro
        move.l  mem_blocks,(a0)
        move.l  \1,BLOCK_SIZE(a0)
        move.l  a0,mem_blocks
        endm

; dos.library
_LVOOpen                equ     -30
_LVOClose               equ     -36
_LVORead                equ     -42
_LVOWrite               equ     -48
_LVOOutput              equ     -60
_LVOSeek                equ     -66
_LVODeleteFile          equ     -72
_LVOCurrentDir           equ     -126
_LVOIoErr               equ     -132
_LVOLoadSeg             equ     -150
_LVOUnLoadSeg           equ     -156
_LVODelay               equ     -198
_LVOAllocDosObject       equ     -228
_LVOFreeDosObject        equ     -234
_LVOSelectOutput        equ     -300
_LVOFault               equ     -468
_LVOPrintFault          equ     -474
_LVORunCommand          equ     -504
_LVOReadArgs            equ     -798
_LVOFreeArgs            equ     -858

DOS_RDARGS              equ     5       ; struct RDArgs
RDA_Source              equ     0
CS_Length               equ     4
RDA_Flags               equ     28
RDAF_NOPROMPT           equ     4

; graphics.library
_LVOOpenFont            equ     -72
_LVOCloseFont           equ     -78
_LVOLoadView            equ     -222
_LVOWaitTOF             equ     -270
_LVOWaitBlit            equ     -228
_LVOOwnBlitter          equ     -456
_LVODisownBlitter       equ     -462

gb_ActiView             equ     34
gb_copinit              equ     38
gb_DisplayFlags         equ     206
PAL_BIT                 equ     2

tf_LoChar               equ     32
tf_HiChar               equ     33
tf_CharData             equ     34
tf_Modulo               equ     38
tf_CharLoc              equ     40
FPF_ROMFONT             equ     1

; input.device
io_Command              equ     28
io_Data                 equ     40
IOStdReq_SIZE           equ     48
IND_ADDHANDLER          equ     9
IND_REMHANDLER          equ     10
ie_Class                equ     4
ie_Code                 equ     6
ie_Qualifier            equ     8
IECLASS_NULL            equ     0
IECLASS_RAWKEY          equ     1
IECLASS_RAWMOUSE        equ     2
IECODE_UP               equ     $80
IEQUALIFIERB_CONTROL    equ     3
IEQUALIFIERB_REPEAT     equ     9       ; of the word
C_KEY                   equ     $33

; ciab.resource
_LVOAddICRVector        equ     -6
_LVORemICRVector        equ     -12
_LVOAbleICR             equ     -18
_LVOSetICR              equ     -24

; custom chips
custom                  equ     $dff000
dmaconr                 equ     $002
vposr                   equ     $004
vhposr                  equ     $006
intenar                 equ     $01c
intreqr                 equ     $01e
bltcon0                 equ     $040
bltafwm                 equ     $044
bltbpt                  equ     $04c
bltapt                  equ     $050
bltdpt                  equ     $054
bltsizv                 equ     $05c
bltsizh                 equ     $05e
bltbmod                 equ     $062
bltamod                 equ     $064
bltdmod                 equ     $066
bltcdat                 equ     $070
denise_id               equ     $07c
cop1lc                  equ     $080
copjmp1                 equ     $088
diwstrt                 equ     $08e
diwstop                 equ     $090
ddfstrt                 equ     $092
ddfstop                 equ     $094
dmacon                  equ     $096
intena                  equ     $09a
intreq                  equ     $09c
bplcon0                 equ     $100
bplcon1                 equ     $102
bplcon3                 equ     $106
bpl1mod                 equ     $108
bpl2mod                 equ     $10a
bplcon4                 equ     $10c
beamcon0                equ     $1dc
diwhigh                 equ     $1e4
fmode                   equ     $1fc
LISA                    equ     $f8     ; denise_id's low byte of AGA
BEAMCON_PAL             equ     $0020
INTB_VERTB              equ     5
INTB_BLIT               equ     6
INTF_BLIT               equ     $0040
INTF_SETCLR             equ     $8000
INTF_INTEN              equ     $4000
INTF_EXTER              equ     $2000
INTF_PORTS              equ     $0008

; CIA-A and CIA-B
ciaa                    equ     $bfe001
ciab                    equ     $bfd000
ciatalo                 equ     $400
ciatahi                 equ     $500
ciatblo                 equ     $600
ciatbhi                 equ     $700
ciaicr                  equ     $d00
ciacra                  equ     $e00
ciacrb                  equ     $f00
ICRB_TA                 equ     0
ICRB_TB                 equ     1
ICRF_TB                 equ     2
ICRF_ALL                equ     $1f
ICRF_OTHERS             equ     $1c     ; alarm, serial, index: not the timers
ICRF_SETCLR             equ     $80
CRAF_START_LOAD         equ     %00010001       ; continuous, counts E-clock
CRAF_STOP               equ     %00000000
CRBF_START_LOAD         equ     %01010001       ; counts underflows of timer A
CRBF_STOP               equ     %01000000
CRBF_COUNT_E            equ     %00010001       ; continuous, counts E-clock

; Call a library routine whose base is already in a6.
lvo     macro
        jsr     _LVO\1(a6)
        endm
