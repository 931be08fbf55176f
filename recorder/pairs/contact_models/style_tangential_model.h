// The tangential models that are compiled anew. LIGGGHTS reads this file several times: no guard.
#include <liggghts/tangential_model_history.h>
