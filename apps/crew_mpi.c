/* The ranks of an MPI run.  Points are given out by a counter that the first
 * rank keeps and all add to (MPI-3, 11.3.4: MPI_Fetch_and_op). */
#include "crew.h"

#include <fcntl.h>
#include <math.h>
#include <mpi.h>
#include <omp.h>
#include <signal.h>
#include <stdbool.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include "catalogue.h"

/* Seconds that a rank which failed waits for others to do so; and between two
 * looks. */
#define END_WAIT 2.0
static const struct timespec a_while = { .tv_nsec = 200000 };

static struct {
    int rank, ranks;
    MPI_Comm ending; /* all ranks, in crew_end */
    MPI_Win window;
    long *counter;  /* of the first rank: the next number; MPI's */
    long next, end; /* of this rank's */
} crew;

/* One computes while others wait: with a thread each, unless asked. */
void crew_begin(int *argc, char ***argv)
{
    int provided;

    MPI_Init_thread(argc, argv, MPI_THREAD_SERIALIZED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &crew.rank);
    MPI_Comm_size(MPI_COMM_WORLD, &crew.ranks);
    MPI_Comm_dup(MPI_COMM_WORLD, &crew.ending);
    MPI_Win_allocate(crew.rank == 0 ? sizeof *crew.counter : 0,
                     sizeof *crew.counter, MPI_INFO_NULL, MPI_COMM_WORLD,
                     &crew.counter, &crew.window);
    MPI_Win_lock_all(0, crew.window);
    if (provided < MPI_THREAD_SERIALIZED || getenv("OMP_NUM_THREADS") == NULL)
        omp_set_num_threads(1);
    const int nowhere = crew.rank > 0 ? open("/dev/null", O_WRONLY) : -1;
    if (nowhere >= 0) {
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
        close(nowhere);
    }
}

size_t crew_rank(void)
{
    return (size_t) crew.rank;
}

size_t crew_ranks(void)
{
    return (size_t) crew.ranks;
}

/* Waits without keeping a core busy, and hears who interrupts. */
static enum status wait_for(MPI_Request *request, const struct monitor *monitor)
{
    for (int done = 0; !done;) {
        MPI_Test(request, &done, MPI_STATUS_IGNORE);
        if (done)
            break;
        if (monitor_tell(monitor, "ranks", 0, 0))
            return STATUS_STOPPED;
        nanosleep(&a_while, NULL);
    }
    return STATUS_OK;
}

/* Whether all ranks are about to end, too; those that failed alone, or were
 * interrupted, wait for nobody long. */
static bool ends_with_all(int code)
{
    const double patience = code == EXIT_DONE        ? HUGE_VAL
                            : code == EXIT_INTERRUPT ? 0.0
                                                     : END_WAIT;
    const double begun = MPI_Wtime();
    MPI_Request request;
    int done = 0;

    MPI_Ibarrier(crew.ending, &request);
    while (MPI_Test(&request, &done, MPI_STATUS_IGNORE) == MPI_SUCCESS &&
           !done && MPI_Wtime() - begun < patience)
        nanosleep(&a_while, NULL);
    return done;
}

int crew_end(int code)
{
    if (!ends_with_all(code))
        MPI_Abort(MPI_COMM_WORLD, code);
    signal(SIGTERM, SIG_IGN); /* mpirun's, to those who leave after a failure */
    MPI_Win_unlock_all(crew.window);
    MPI_Win_free(&crew.window);
    MPI_Comm_free(&crew.ending);
    MPI_Finalize();
    return code;
}

enum status crew_agree(enum status status, struct fault *why,
                       const struct monitor *monitor)
{
    int own[2] = { (int) status, crew.rank }, worst[2];
    MPI_Request request;

    if (status == STATUS_STOPPED)
        return status; /* who is interrupted waits for nobody */
    MPI_Iallreduce(own, worst, 1, MPI_2INT, MPI_MAXLOC, MPI_COMM_WORLD,
                   &request);
    if (wait_for(&request, monitor) != STATUS_OK)
        return STATUS_STOPPED;
    if (worst[0] != STATUS_OK)
        MPI_Bcast(why->text, sizeof why->text, MPI_CHAR, worst[1],
                  MPI_COMM_WORLD);
    return (enum status) worst[0];
}

size_t crew_told(size_t number)
{
    unsigned long long told = number;

    MPI_Bcast(&told, 1, MPI_UNSIGNED_LONG_LONG, 0, MPI_COMM_WORLD);
    return (size_t) told;
}

void crew_share_begin(void)
{
    MPI_Barrier(MPI_COMM_WORLD);
    if (crew.rank == 0) {
        const long none = 0;
        long before;
        MPI_Fetch_and_op(&none, &before, MPI_LONG, 0, 0, MPI_REPLACE,
                         crew.window);
        MPI_Win_flush(0, crew.window);
    }
    crew.next = crew.end = 0;
    MPI_Barrier(MPI_COMM_WORLD);
}

/* So many at once that each rank asks some hundred times. */
static long chunk_of(size_t count)
{
    const size_t chunk = count / (100 * (size_t) crew.ranks);

    return chunk < 1 ? 1 : chunk > 1024 ? 1024 : (long) chunk;
}

size_t crew_share_next(void *ctx, size_t count)
{
    (void) ctx;
    if (crew.next == crew.end) {
        const long chunk = chunk_of(count);
        MPI_Fetch_and_op(&chunk, &crew.next, MPI_LONG, 0, 0, MPI_SUM,
                         crew.window);
        MPI_Win_flush(0, crew.window);
        crew.end = crew.next + chunk;
    }
    return (size_t) crew.next < count ? (size_t) crew.next++ : count;
}
