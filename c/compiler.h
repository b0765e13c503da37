/* The integer types, and all that differs between C compilers.
   The C is C99 without library, without long long and without extensions. */
#ifndef COMPILER_H
#define COMPILER_H

typedef signed char int8;
typedef unsigned char uint8;
typedef signed short int16;
typedef unsigned short uint16;
typedef signed int int32;
typedef unsigned int uint32;

/* Signed 16.16 fixed point: -32768 to 32768 - 1/65536, steps of 1/65536. */
typedef int32 fix16;

/* A cast of a negative value to unsigned and back is modular in both compilers;
   >> of a negative value is arithmetic in both. */

#endif
