/* The display, the ROM's font and the keys: src68k/amiga, contracts there. All are given back when
   the program ends, even after a break or a crash. */
#ifndef DISPLAY_H
#define DISPLAY_H

#include "compiler.h"

enum font_constants {
    FONT_FIRST = 32, FONT_LETTERS = 96, FONT_ROWS = 8
};

#define NO_KEY 0xffffffffu

/* Raw key codes. */
enum key { KEY_S = 0x21, KEY_G = 0x24, KEY_SPACE = 0x40, KEY_ESCAPE = 0x45, KEY_UP = 0x4c, KEY_DOWN, KEY_RIGHT,
           KEY_LEFT };

int32 display_has_aga(void);
int32 display_open(const uint16 *list);
void display_show(const uint16 *list);
void display_post(const uint16 *list, uint32 field);
void display_wait(uint32 field);
uint32 display_shown(void);
uint32 display_since(void);
uint32 display_age(void);
uint32 display_fields(void);
void display_close(void);
int32 font_read(uint8 *letters);
int32 keys_open(void);
uint32 key_take(void);
void keys_close(void);

#endif
