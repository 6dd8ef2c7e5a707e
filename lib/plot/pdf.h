/* pdf.h -- makes a PDF file independent of when it was made. */
#ifndef PLOT_PDF_H
#define PLOT_PDF_H

#include "status.h"

/* Overwrites the digits of each /CreationDate that stands in plain text by
 * 1970-01-01, without moving a byte.  A file without one stays as it is, which
 * is no error. */
MUST_CHECK enum status pdf_forget_date(const char *path);

#endif
