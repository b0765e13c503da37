; intuition.library, and what of graphics.library its screens take. Source: the public autodocs and includes.

        ifnd    INTUITION_I
INTUITION_I equ 1

        include "amiga.i"

VERSION_39              equ     39      ; Kickstart 3.0: AllocScreenBuffer, LoadRGB32

_LVOCloseScreen         equ     -66
_LVOCloseWindow         equ     -72
_LVOSetPointer          equ     -270
_LVOOpenWindowTagList   equ     -606
_LVOOpenScreenTagList   equ     -612
_LVOAllocScreenBuffer   equ     -768
_LVOFreeScreenBuffer    equ     -774
_LVOChangeScreenBuffer  equ     -780
_LVOLoadRGB32           equ     -882    ; graphics.library
_LVOSetChipRev          equ     -888
_LVOGetBitMapAttr       equ     -960
_LVOAllocDBufInfo       equ     -966
_LVOFreeDBufInfo        equ     -972

SA_Width                equ     $80000023
SA_Height               equ     $80000024
SA_Depth                equ     $80000025
SA_Type                 equ     $8000002d
SA_DisplayID            equ     $80000032
SA_ShowTitle            equ     $80000036
SA_Quiet                equ     $80000038
SA_Interleaved          equ     $80000042
CUSTOMSCREEN            equ     15
LORES_KEY               equ     0       ; of the default monitor

WA_IDCMP                equ     $8000006a
WA_Flags                equ     $8000006b
WA_CustomScreen         equ     $80000070
IDCMP_RAWKEY            equ     $400
; SIMPLE_REFRESH, BACKDROP, BORDERLESS, ACTIVATE, RMBTRAP, NOCAREREFRESH
WINDOW_FLAGS            equ     $31940

sc_ViewPort             equ     44      ; struct Screen
sc_BitMap               equ     88      ; its RastPort's
wd_UserPort             equ     86      ; struct Window
im_Code                 equ     24      ; struct IntuiMessage
im_Qualifier            equ     26
SETCHIPREV_BEST         equ     -1
GFXB_AA_LISA            equ     3
SB_SCREEN_BITMAP        equ     1
sb_BitMap               equ     0       ; struct ScreenBuffer
sb_DBufInfo             equ     4
BMA_FLAGS               equ     12
BMF_STANDARD            equ     8
AROS_WRONG              equ     65536
dbi_SafeMessage         equ     8       ; struct DBufInfo
dbi_DispMessage         equ     40
mn_ReplyPort            equ     14
is_Type                 equ     8       ; struct Interrupt
is_Name                 equ     10
is_Data                 equ     14
is_Code                 equ     18

; Pushes a tag and its data; what is pushed first comes last.
tag     macro
        move.l  \2,-(sp)
        move.l  #\1,-(sp)
        endm

        endc
