/* The routines of src68k/amiga; contracts there. */
#ifndef SYSTEM_H
#define SYSTEM_H

#include "compiler.h"
#include "system/memory.h"

/* Return codes of programs. */
enum return_code {
    RETURN_OK = 0,      /* everything is done */
    RETURN_WARN = 5,    /* polygons were refused, or Ctrl-C; the files written are complete */
    RETURN_ERROR = 10,  /* wrong arguments, or a file that is invalid or cannot be read or written:
                           the user can fix it */
    RETURN_FAIL = 20    /* the machine lacks something: processor, Kickstart, memory, timers,
                           chips; or the program crashed */
};
enum file_mode { FILE_OLD = 1005, FILE_NEW = 1006 };

/* A routine that gives something back at the program's end; see at_end. Keeps d2-d7/a2-a6. */
struct end {
    struct end *next;
    void (*routine)(void);
};

void at_end(struct end *end);
int32 break_asked(void);
int32 file_open(const char *name, int32 mode);
int32 file_read(int32 file, void *data, int32 bytes);
int32 file_write(int32 file, const void *data, int32 bytes);
int32 file_size(int32 file);
void file_close(int32 file);
void file_delete(const char *name);
void print(const char *text);
int32 args_read(const char *template_text, int32 *items);
uint32 program_load(const char *name);
void program_unload(uint32 program);
uint32 program_base(void);
int32 program_enter(uint32 program, const char *arguments, int32 bytes);
int32 program_run(uint32 program, const char *arguments, int32 bytes, const char *output);
int32 mem_alloc(void *address, int32 bytes, int32 kind);
int32 mem_asked(int32 *kind);
int32 mem_largest(int32 kind);
void mem_reserve(void);
int32 mem_take_at(void *address, int32 bytes);
uint32 mem_lists(void);
uint32 mem_mark(void);
void mem_release(uint32 mark);
int32 mem_need(void *address, int32 bytes, int32 kind);
int32 mem_need_take(void *address, int32 bytes, int32 kind);

void tasks_forbid(void);
void tasks_permit(void);
int32 clock_open(void);
void clock_close(void);
void clock_wait(void);
void clock_start(int32 limit);
uint32 clock_stop(void);
void quiet_enter(void);
void quiet_leave(void);
int32 cache_data(void);
void exact_set(int32 on);

#endif
