/* library.h -- the HDF5 library itself. */
#ifndef STORE_LIBRARY_H
#define STORE_LIBRARY_H

/* HDF5 prints nothing from now on.  For programs, before their first store;
 * it starts HDF5, so those without a store should not call it. */
void store_silence(void);

/* "1.10.8": the version linked. */
const char *store_library_version(void);

#endif
