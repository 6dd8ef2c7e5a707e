/* own_folder.h -- an empty folder for each test, removed after it.
 *
 *     cmocka_unit_test_setup_teardown(test, own_folder_make, own_folder_remove)
 */
#pragma once

#include <stddef.h>

int own_folder_make(void **state);
int own_folder_remove(void **state); /* with all that is in it */

/* Of the running test; "" for the folder itself, else FOLDER/name.  One of
 * eight buffers in turn. */
const char *own_path(const char *name);

/* Files and folders in it, however deep. */
int own_folder_entries(void);

/* The test fails where these do. */
void file_write(const char *path, const void *bytes, size_t size);
char *file_read(const char *path, size_t *size); /* owned by the caller */
void file_holds(const char *path, const char *text);
