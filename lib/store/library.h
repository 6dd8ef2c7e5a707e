/* library.h -- the HDF5 library itself. */
#ifndef STORE_LIBRARY_H
#define STORE_LIBRARY_H

/* HDF5 prints nothing from now on; main() calls it once. */
void store_silence(void);

/* "1.10.8": the version linked. */
const char *store_library_version(void);

#endif
