/*
 * litter.h -- what must not outlive the program: temporary files and folders
 * and a child, known to whoever has to end it at once (from a signal handler).
 */
#pragma once

#include <sys/types.h>

/* A path, borrowed until it is dropped; by one thread at a time.  What finds no
 * place among the few is not known. */
void litter_add(const char *path);
void litter_drop(const char *path);

/* The child that is waited for; 0: none. */
void litter_child(pid_t child);

/* Kills the child, removes files and folders, the last one first.  May be
 * called from a signal handler. */
void litter_sweep(void);
