// The tangential models that this program compiles anew. LIGGGHTS reads this file several times over, so it
// has no guard.
#include <liggghts/tangential_model_history.h>
