/* Reads files as a fuzz target does: replay FILE...  Ends as the target does
 * over the first that is a finding, after its name. */
#include <stdbool.h>

#include "fuzz.h"

static bool replay(const char *path)
{
    FILE *file = fopen(path, "rb");
    uint8_t *bytes = NULL;
    size_t size = 0, got = 1;

    printf("%s\n", path);
    fflush(stdout);
    while (file && got > 0) {
        bytes = realloc(bytes, size + (1 << 16));
        MUST(bytes != NULL);
        got = fread(bytes + size, 1, 1 << 16, file);
        size += got;
    }
    if (file == NULL)
        return false;
    fclose(file);
    /* exactly its size, so that a sanitizer sees who reads beyond */
    uint8_t *data = malloc(size > 0 ? size : 1);
    MUST(data != NULL);
    for (size_t i = 0; i < size; i++)
        data[i] = bytes[i];
    free(bytes);
    LLVMFuzzerTestOneInput(data, size);
    free(data);
    return true;
}

int main(int argc, char *argv[])
{
    for (int i = 1; i < argc; i++)
        if (!replay(argv[i]))
            return 2;
    return argc > 1 ? 0 : 2;
}
