/* A host in C99 that fills every struct and calls every function of tactus.h once. */
#ifndef TACTUS_TESTS_C99_PROGRAM_H
#define TACTUS_TESTS_C99_PROGRAM_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* 0, or the number of the line where something went wrong. The model has inputs depth and speed and no other. */
int runC99Program(const char* text, size_t size, double* force_n, double* feel_n);

#ifdef __cplusplus
}
#endif

#endif
