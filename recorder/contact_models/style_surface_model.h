// The surface models that this program compiles anew. LIGGGHTS reads this file several times over, so it
// has no guard.
#include <liggghts/surface_model_default.h>
