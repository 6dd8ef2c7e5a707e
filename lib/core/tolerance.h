/*
 * tolerance.h -- the tunable numbers of geometry, portraits, scenes and files:
 * default, unit, reason.  Those of orbits, slow curves, basins, numbers,
 * studies, sweeps and races are in ROOM_tolerance.h of their rooms.
 */
#pragma once

/* Relative error asked for when the scene does not say (dimensionless):
 * what double precision can hold with a margin for the bars. */
#define TOL_RTOL_DEFAULT 1e-12
/* The least tolerance of a step (relative): some hundred of them, each rounded
 * by 2^-52, then err by no more. */
#define TOL_FINEST 3e-14

/* What a result is made from, steps, solved equations, a finer run, is as
 * accurate as this part of what is asked of it. */
#define TOL_PART 0.03

/* Roundings, in units of roundoff (2^-52), of a number made by so many of them,
 * where no part is larger than the whole: n operations err by n/2 (Higham,
 * Accuracy and Stability, 2002, lemma 3.1).  Few: an expression of a field;
 * some: a polynomial of order 20 and a step of twelve stages, to both sides;
 * many: sums of a hundred terms, of a thousand with signs of their own. */
#define TOL_ROUNDINGS_FEW  4.0
#define TOL_ROUNDINGS      16.0
#define TOL_ROUNDINGS_MANY 64.0
/* What rounding does to a coordinate, a logarithm or its exponential, per unit
 * of it: half a unit of its last digit, and as much again of a logarithm. */
#define TOL_ROUNDING 0x1.8p-53
/* Sums of time and slip, whose factors have lost digits below 2^-1022, or
 * vanished, and were multiplied by less than 2^52 since. */
#define TOL_VANISHING 0x1p-970
/* Relative: less than this is rounding and says nothing, of slopes, sums and
 * areas as of formulas that are the same: 2^-52 of some hundred terms that
 * cancel in part; where something is, it is larger by decades.  Shares of a
 * window, where nothing cancels, round by far less, TOL_FAR_BELOW of it. */
#define TOL_ROUNDED 1e-13
/* Parts of a whole, of which only the order counts.  LITTLE: of no weight
 * beside it.  FAR_BELOW: of two, as rates, slopes or shares, one goes its way
 * without the other.  SHARE: what one of three causes of a bar may take of it,
 * or a stride of a way.  CLEARLY: the larger or nearer one of two is told by
 * it. AIM: of what is allowed, steps and parts aim at it, for a refused one
 * costs more.  AS_BEFORE: what goes on as it did exceeds it by no more than
 * this. MARGIN: beyond the sides of a box, in sides, so that nothing ends on
 * them. */
#define TOL_LITTLE    0.01
#define TOL_FAR_BELOW 0.1
#define TOL_SHARE     0.3
#define TOL_CLEARLY   0.5
#define TOL_AIM       0.7
#define TOL_AS_BEFORE 1.1
#define TOL_MARGIN    0.05
/* A way in ln v or ln psi along which laws are as good as their series. */
#define TOL_NEARBY 0.1

/* What errs by the square of it is known to rounding: the root of 2^-53. */
#define TOL_ROOT 1e-8
/* Below this part of itself no double changes any more. */
#define TOL_NOTHING 1e-18
/* e-folds after which what fades is below rounding, ln 2^52. */
#define TOL_SETTLED 36.0

/* In sides of a window or of a drawing, in ln v, relative.  Places nearer to
 * each other than SAME are one, strips and regions smaller than it are none: a
 * thousand times what curves are off; WITHIN is surely nearer, BESIDE surely
 * further than that.  Curves that are only looked at are off
 * by DRAWN, which is less than a px, and may end SEEN beside where they go.
 * TOUCH: as near as computing with doubles comes to a place.  Where a field
 * changes over less than SAME, series are in a smaller unit, and in a larger
 * one where steps are longer than its inverse: thirtieth powers overflow. */
#define TOL_TOUCH  1e-12
#define TOL_WITHIN 1e-7
#define TOL_SAME   1e-6
#define TOL_BESIDE 1e-5
#define TOL_DRAWN  1e-4
#define TOL_SEEN   1e-3

/* Arrows of the direction field along each side of the window. */
#define PORTRAIT_ARROWS 20

/* How far beside a point, in ln v and ln psi, in sides of a window or in parts
 * of a way, its neighbour is whose difference tells a slope: curvature and
 * rounding over it, 2^-53, are both below 1e-6 of it. */
#define TOL_ASIDE 1e-6

/* As far as doubles go, dimensionless: v (and psi where it is positive), both
 * ways, of the laws and of scenes; times, at which an orbit at rest ends. */
#define TOL_RANGE 1e300
#define LN_RANGE  690.7755278982137 /* its logarithm */
/* Range of psi where psi is itself a logarithm: down to -TOL_RANGE, for
 * friction only fades there; up to ROOM above the anchor, where e^psi has
 * passed all that it is compared with. */
#define TOL_PSI_ROOM 700.0

/* Trajectories, relative error per unit of ln v, ln psi: three digits more
 * cost twice the time; figures and energy balances to nine digits are
 * plenty. */
#define TOL_ORBIT_RTOL 1e-9

/* Steps that an orbit may take, of any system, and halvings on a way to a
 * passage: ten times what an accurate one to a node needs, and a hang is worse
 * than an error. */
#define TOL_ORBIT_STEPS 60000

/* Steps before an orbit that has not come to its end is left to the implicit
 * method, or has stopped, where they take no time, to and fro: more than it
 * takes for all of a fast motion there and back. */
#define TOL_EXPLICIT_STEPS 1000

/* An orbit has arrived when it is this near an equilibrium, in both ln v and
 * ln psi: one per cent is what friction experiments resolve. */
#define TOL_ARREST 0.01

/* Iterations of Newton's method, halvings, searches beside a corner: each
 * gains a binary digit at least, so that none is ended by this that converges.
 */
#define TOL_ITERATIONS 60

/* Taylor series along a manifold: order = base - per digit * log10(rtol), 22
 * at 1e-12 (16 to 28 tie in speed) and 14 at 1e-6; and the tolerance of one
 * step for a promise of rtol on the result: step errors add up over some fifty
 * steps. */
#define TOL_ORDER_BASE      6.0
#define TOL_ORDER_PER_DIGIT 1.35
#define TOL_TAYLOR_STEP     0.02
/* What a step leaves out is its first missing term where terms fall at least
 * like powers of SMOOTH; they may fall more slowly than the last ones by
 * TOL_AS_BEFORE.
 * Else its bar is so many times that term and the last ones; the first one is
 * no more than NEXT of the last ones, but what roundings make of it (beside a
 * kink terms may be small by chance). */
#define TOL_STEP_SMOOTH   0.8
#define TOL_STEP_BAR_NEXT 4.0
#define TOL_STEP_BAR_LAST 0.4
/* Roundings of all steps together, each with a sign of its own, are so many
 * times the root of the sum of their squares. */
#define TOL_ROUNDING_BAR 2.5
/* Errors travel over a step by the mean of their rates at its ends, which is
 * off by no more than this part of the difference (an exponential's is, up to
 * thirtyfold); and the most one grows, as an exponent, beyond which nothing is
 * known, as the longest step that is not short beside the way so far. */
#define TOL_STEP_BEND 0.25
#define TOL_STEP_MOST 50.0
/* Steps of a branch, of which most need some fifty, and down to psi of -1e300
 * some five a unit of ln |psi|; pieces that a sum is halved into, at most. */
#define TOL_BRANCH_STEPS 5000
/* Integrals below this have no digits in a double: the smallest normal number
 * over its roundoff. */
#define INTEGRAL_NIL 1e-292
/* Never a series start further than this from the saddle, in ln v or ln psi:
 * beyond, the defect at the two ends no longer speaks for the middle. */
#define TOL_SERIES_RADIUS_MAX 2.0
/* A step is kept when the series' slope agrees with the field's at its end to
 * this many times its tolerance: a derivative loses a factor of the order. */
#define TOL_SLOPE_CHECK 300.0
/* A step's end says little where the slope is far below that at its start,
 * where that is below LITTLE times what is allowed, and where the step is LEAP
 * times as long as the one before: by chance its last terms may vanish. */
#define TOL_SLOPE_LITTLE 100.0
#define TOL_STEP_LEAP    1.5
/* Slope |dy/dx| above which x becomes the unknown, and below which y does
 * again: apart, so that the choice does not flip back and forth. */
#define TOL_SLOPE_STEEP 4.0
#define TOL_SLOPE_FLAT  0.3
/* Further from the saddle than this in y, as a logarithmic psi may be, slopes
 * are counted relative to y: by less than y itself it hardly moves. */
#define TOL_SLOPE_FAR 1e3
/* What is left of a branch is tried by quadrature when it changes by less than
 * PART sqrt(rtol) and TOL_SEEN a unit, relative to min(1, unknown), and taken
 * when the quadrature's error is small, at the latest below TOL_ROOT (of 1,970
 * tails of presets at 1e-6 to 1e-12 none was small above 1.9). */
#define TOL_TAIL_PART 2.0
/* A bar is this many times what it is made of, where that is known to first
 * order: the difference of two quadratures (measured: a kink beyond a branch
 * cost 1.1 of it, once in 50 000), what defects make of a branch (five Gauss
 * points see them to a few per cent), what steps make of an orbit.  And so many
 * times the difference of two runs, or the largest miss of some tests, which
 * may be small by chance. */
#define TOL_BAR_FIRST_ORDER 2.0
#define TOL_BAR_CHANCE      8.0

/* Step control (control.h, orbit.h).  Safety: aim for an error of about half
 * the tolerance, since a rejected step costs more than a short one. */
#define TOL_STEP_SAFETY 0.9
/* The step never changes by more than this: an estimate is local. */
#define TOL_STEP_SHRINK 0.2
#define TOL_STEP_GROWTH 5.0
/* Errors below this fraction of the tolerance count as this in the control. */
#define TOL_STEP_ERROR_FLOOR 1e-4
/* Shorter steps are no steps: reached after some fifty rejections, as where
 * a field is NaN. */
#define TOL_STEP_MIN 1e-30
/* Steps between two calls of a monitor, or looks at how an orbit goes on. */
#define TOL_MONITOR_STEPS 64

/* Samples of each event function, and of friction, on a piece: polynomials of
 * degree at most 7 seldom turn more often than this resolves. */
#define TOL_EVENT_SAMPLES 8
/* Shortest stride, in theta, of the walk to a passage: what stays beyond for
 * less grazes by less than a thousandth of the way a piece can make. */
#define TOL_PASSAGE_STEP 0x1p-10
/* The same into a box, as a fraction of its width, far below what an orbit is
 * off, and in theta, where rounding is all that moves. */
#define TOL_PASSAGE_CHORD 0x1p-40
/* An orbit whose steps shrink below this times |z| is stuck: z + h = z, as
 * where the field ends in NaN. */
#define TOL_ORBIT_STALL 1e-15
/* Logarithms from which e^-L is near the end of the doubles. */
#define TOL_RESCALED_FAR 500.0

/* Straight lines stay this near to the curve that they stand for, in dots of
 * the page, where those of SVG and PDF are taken to be as small as this many to
 * an inch: twice, where points are chosen and where some are left out again,
 * together a quarter of a dot, which no eye sees. */
#define TOL_FIGURE_DOT 0.125
#define TOL_FIGURE_DPI 300.0
/* Cells along each side of a drawn raster, at least: about as many as there
 * are px, so that a viewer that blurs images blurs nothing visible. */
#define TOL_FIGURE_CELLS 400

/* Nullclines, lengths as fractions of the window's sides.  Grid on which their
 * signs are looked at, cells a side: what is smaller than a cell, or two pieces
 * nearer than one, may be missed. */
#define TOL_NULLCLINE_CELLS 64
/* Longest step, and the tangent of the largest angle between the chord and the
 * tangents at its ends: beyond, the step may have changed over to another
 * piece; of a step shorter than TOL_WITHIN, the curve has a cusp, and zeros
 * nearer to each other are one (roots are closed far below). */
#define TOL_NULLCLINE_STEP_MAX 0x1p-5
#define TOL_NULLCLINE_ANGLE    0.3
/* A step is smooth when the curve is this near the cubic through its ends and
 * tangents, as a fraction of the cubic's height: a circle is off by 0.01 at
 * the largest angle allowed, a change to a crossing piece by more than 0.1.
 * Whether a zero lies on a step is asked when it is this near the chord, as a
 * fraction of it: more than the angle above allows. */
#define TOL_NULLCLINE_SMOOTH 0.05
#define TOL_NULLCLINE_NEAR   0.1
/* Steps of a curve that is drawn, a trajectory or a piece of a nullcline, and
 * of an orbit of formulas: enough for fifty turns around a centre, and a hang
 * is worse than a gap. */
#define TOL_CURVE_STEPS 20000

/* Traps (arrival.h), in sides of a window: looked for from 2^-LEVELS up to 1/2,
 * LEAST levels or none.  Closed orbits: differences between rounds are at most
 * TOL_WITHIN, each less than the one before by SHRINK or no more than
 * TOL_ROUNDED or a round is off; the round is TOL_BESIDE from where the curve
 * started, and larger, and further from any equilibrium, than TOL_SAME and ten
 * times what such differences add up to. */
#define TOL_TRAP_LEVELS    30
#define TOL_TRAP_LEAST     8
#define TOL_WINDING_SHRINK 0.99

/* A curve between places that follow each other is straight up to this
 * (escape.h): half, and a margin. */
#define TOL_ESCAPE_CHORD 0.6

/* The way back of an orbit (streamline.h), in sides of the drawing: a step's
 * length, and how long the whole may be, as around a centre. */
#define TOL_STREAMLINE_STEP   0.05
#define TOL_STREAMLINE_LENGTH 8.0

/* Trajectories of a portrait: candidates for each start; spacing of the points
 * that stand for a curve when the next starts are chosen (fractions of the
 * window). */
#define TOL_PORTRAIT_CANDIDATES 16
#define TOL_PORTRAIT_SPACING    0.02

/* HDF5 files.  Side of the square chunks of a grid, in cells: half a megabyte
 * of doubles, which stays in HDF5's chunk cache of 1 MiB. */
#define STORE_CHUNK 256
/* Level of zlib: higher ones cost several times more for a few per cent. */
#define STORE_DEFLATE 1
/* Up to so many attributes, or links of a group, stand in the object's header:
 * beyond, a B-tree and a heap cost less than looking through them all. */
#define STORE_COMPACT 64
/* Growth of a file in memory, bytes: larger than most whole files. */
#define STORE_GROWTH ((size_t) 1 << 20)

/* Scenes.  Bytes of a file, depth of nesting, keys of one map: far more than a
 * scene needs, so that a wrong file is refused at once. */
#define SCENE_BYTES ((size_t) 1 << 20)
#define SCENE_DEPTH 16
#define SCENE_KEYS  64
/* Values of estimates.xi: each is one column of a report. */
#define SCENE_XI 64
/* Values of chi.alpha: each is one curve of a figure. */
#define SCENE_CHI 64

/* Tables (CSV).  Bytes of a file, bytes of a cell, columns: far more than a
 * table of numbers needs, so that a wrong file is refused at once. */
#define TABLE_BYTES   ((size_t) 64 << 20)
#define TABLE_CELL    4096
#define TABLE_COLUMNS 1024

/* Checks against stored numbers.  Today's are computed to this accuracy, so
 * that their own bars hide as little as possible. */
#define CHECK_RTOL 1e-13
/* What rounding the inputs costs is a difference (conditioning.h), and no
 * derivative: a margin. */
#define CHECK_MARGIN 1.2
/* What is recorded may differ from what is recomputed by two error bars: each
 * is that near the truth. */
#define CHECK_RECORDED_BARS 2.0

/* From so many rows of a basin map on, threads pay. */
#define BASIN_PARALLEL_ROWS 4096

/* A piece whose slope stays further than this from 1 has no knee. */
#define TOL_KNEE_NEAR 0.05
/* Turning points and variations: the shortest part of a piece that is halved.
 */
#define TOL_PIECE_SHORTEST 0x1p-20

/* The clock of an orbit: this part of the field's largest rate, so that its
 * rounding, 1e-15 of it, stays far below, and the stages of a step, which start
 * as far as this from a slow curve, are solved without slowing the clock. */
#define TOL_ORBIT_PACE 1e-6

/* What is carried along an orbit (drift.h).  The bar, beside the error to first
 * order: standard deviations of the rest; what part of a step's error is of
 * higher order, beside what two halves of the step see of it and the whole does
 * not; how many times as fast one component may settle as the other; and how
 * near to the saddle it passes it, in the chart. */
#define TOL_DRIFT_NOISE  4.0
#define TOL_DRIFT_UNSURE 0.25
#define TOL_DRIFT_STIFF  1e7
#define TOL_DRIFT_NEAR   1.0

/* Steps of radau.h.  Iterations, at most; how much less sure a rate is that was
 * measured on the step before, and the least such rate (a lucky one says
 * nothing); changes that are nothing: the same part of the tolerance, or what
 * two iterates round by, TOL_ROUNDINGS of the coordinates each. */
#define TOL_RADAU_ITERATIONS 10
#define TOL_RADAU_DISTRUST   10.0
#define TOL_RADAU_LEAST      1e-3

/* Steps of an orbit.  Its equations are solved to TOL_PART; stages are guessed
 * from the step before when they lie this far ahead of it, in its lengths, and
 * so a trend lengthens no step by more; an iteration should leave TOL_FAR_BELOW
 * of the error (measured: longer steps cost more iterations than they save),
 * and steps retreat by this factor at a time from where it does not. */
#define TOL_ORBIT_EXTEND  3.0
#define TOL_ORBIT_RETREAT 0.5

/* A slope that decays faster than this, per unit of ln v or ln psi, has a
 * limit: those of laws decay at a rate of 1 at least, or do not. */
#define TOL_LIMIT_DECAY 0.2
/* One that falls like 1/Y has none: Y times it keeps this part, which a pole
 * beside the origin costs, up to the root of TOL_RANGE times as far, which a
 * square of it is still a number at. */
#define TOL_LIMIT_KEPT 0.9

/* The coarsest relative accuracy that still follows slow curves, and that of
 * the fields of a basin map where the scene does not say: four digits more than
 * arrest is defined to. */
#define TOL_COARSEST 1e-6

/* Relative defect of the balance of energy of a transient that is wrong, in
 * units of rtol (measured: 1e-3). */
#define TOL_TRANSIENT_ENERGY 1e5

/* Fits to Rabinowicz's experiment (lib/fit).  Iterations and tolerance of the
 * parameters, of order one: far below what noise leaves; passes that find
 * weights from the curve (measured: at noise of 1 % the second moves mu_s by
 * 0.02 of its standard deviation, the third by 1e-4, a fourth by 1e-6); where
 * the curve is below this part of a value, the weight stays as it was. */
#define FIT_ITERATIONS   200
#define FIT_TOLERANCE    1e-12
#define FIT_PASSES       3
#define FIT_WEIGHT_LEAST 0.1
/* Outside a 95 % interval on each side; and the chance below which a chi2 is
 * told to be too large. */
#define FIT_TAIL   0.025
#define FIT_CHANCE 1e-3
/* Where the band of a curve leaves zero: the first step, in widths expected;
 * growth of steps, slow, lest one jump over a gap; beyond this, in half ranges
 * of the data, nothing bounds it; halvings of the last step. */
#define FIT_BAND_STEP     0.02
#define FIT_BAND_GROWTH   1.02
#define FIT_BAND_FAR      100.0
#define FIT_BAND_HALVINGS 60
/* (30) is (31) to rounding above this ln v_sp0, and nothing above this psi. */
#define FIT_STRAIGHT 20.0
#define FIT_GONE     700.0
/* Smoothings tried: at the largest, modes of sin(pi u) fade to a thousandth;
 * at the least, those of sin(9 pi u) to a half; factor between two.  Where a
 * curve is lower than this part of its top, it bends as if it were not; points
 * of a curve. */
#define FIT_SMOOTHEST   1.0
#define FIT_ROUGHEST    1e-9
#define FIT_SMOOTHER    2.0
#define FIT_FLAT        0.01
#define FIT_SLIP_POINTS 101

/* Scenes of Rabinowicz's experiment: slopes of a list, each a computation of
 * milliseconds; the steepest; and the least smoothing, far below what keeps
 * any data's noise. */
#define SCENE_SLOPES          1000
#define SCENE_TAN             1e6
#define SCENE_SMOOTHING_LEAST 1e-12

/* Points of a sweep in all, 500 x 500: a million studies are hours, and their
 * numbers fill memory before (1.4 kB a point). */
#define SCENE_POINTS 250000

/* Of an ensemble (scene_ensemble.c): draws, of which a file holds a row each;
 * parameters, fewer than the dimensions of GSL's Sobol sequence; numbers and
 * pushes. */
#define SCENE_DRAWS         1000000000
#define SCENE_DRAWS_DEFAULT 10000
#define SCENE_SPREADS       32
#define SCENE_NUMBERS       256
#define SCENE_PUSHES        64

/* A block pulled through a spring: sigma where the scene gives none, that of a
 * decimetre of rock or paper board; and the c of fold curves, from where even
 * the minimum of mu_ss is next to no friction to beyond the cusp (Table 2). */
#define SCENE_SIGMA 1e3
/* States that audit the basins of a system of formulas, unless a scene says. */
#define SCENE_SYSTEM_AUDIT 200
#define SCENE_FOLD_LEAST   1e-14
#define SCENE_FOLD_MOST    10.0

/* Files of others, read by a child (child.h).  Seconds to list one, and to
 * compare two, where 32768 x 32768 cells may have to be unpacked; bytes of
 * address space beyond what the program has (a listing takes some MB, a
 * comparison two blocks of CHILD_BLOCK bytes and HDF5's own); bytes of what
 * comes back, far more than any list of names and texts. */
#define CHILD_LIST_SECONDS    60u
#define CHILD_COMPARE_SECONDS 3600u
#define CHILD_BYTES           ((size_t) 2 << 30)
#define CHILD_BLOCK           ((size_t) 16 << 20)
#define CHILD_ANSWER          ((size_t) 64 << 20)

/* Cells of a sweep's maps in all: about 10 bytes each in memory while the file
 * is written, 10 GB. */
#define SCENE_SWEEP_CELLS 1e9

/* A data set of fewer values is not compressed: chunks take 2 kB of their own.
 */
#define STORE_LARGE 4096
/* Values of an index that are written at a time. */
#define STORE_INDEX 4096

/* Systems for other programs.  A motion starts that far beside a steady state,
 * in ln v, and lasts so many times what its slowest rate takes.  A branch has
 * reached its limit where its slope is this (they print 8 digits), looked for
 * in such strides; one without a limit is followed over so much arc of the
 * chart.  Steady states are continued so far, rad, beyond the folds and the
 * slope. */
#define EXCHANGE_KICK   0.1
#define EXCHANGE_RATES  20.0
#define EXCHANGE_FLAT   1e-12
#define EXCHANGE_STRIDE 0.5
#define EXCHANGE_ARC    40.0
#define EXCHANGE_MARGIN 0.05
