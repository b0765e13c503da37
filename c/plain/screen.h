/* Chunky to planar in plain C, bit by bit: references for the bench. */
#ifndef PLAIN_SCREEN_H
#define PLAIN_SCREEN_H

#include "screen/planar.h"

void c2p_8_c(const struct planar_plan *plan);
void c2p_8_2x1_c(const struct planar_plan *plan);
void c2p_ham8_16_c(const struct planar_plan *plan);
void c2p_ham8_5551_c(const struct planar_plan *plan);
void c2p_ham8_32_c(const struct planar_plan *plan);

#endif
