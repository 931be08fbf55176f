#include "orchestrator/app/verbs.h"

#include <array>
#include <memory>

#include "orchestrator/app/calibrate_verb.h"
#include "orchestrator/app/check_verb.h"
#include "orchestrator/app/compare_verb.h"
#include "orchestrator/app/deck_verb.h"
#include "orchestrator/app/draw_verb.h"
#include "orchestrator/app/export_verb.h"
#include "orchestrator/app/import_verb.h"
#include "orchestrator/app/mesh_verb.h"
#include "orchestrator/app/new_verb.h"
#include "orchestrator/app/postprocess_verb.h"
#include "orchestrator/app/report_verb.h"
#include "orchestrator/app/run_verb.h"
#include "orchestrator/app/status_verb.h"
#include "orchestrator/app/study_verb.h"
#include "orchestrator/app/tune_verb.h"
#include "orchestrator/app/wear_verb.h"

namespace millwear::orchestrator {
namespace {

/// Options and action of a verb as the table wants them.
template <class Options, void (*action)(const Options&)>
std::function<void()> prepare(CLI::App& command_line) {
  const auto options = std::make_shared<Options>();
  add_options(command_line, *options);
  return [options] { action(*options); };
}

constexpr std::array table{
    Verb{"new", "Write a first case file from a drawing or a few numbers",
         "  millwear new my_mill.toml --shell-diameter 1 --rows 12 --filling 0.31 --balls "
         "30:60,25:40\n"
         "  millwear new my_mill.toml --from-drawing liner.dxf --shell-diameter 8 --rows 52 \\\n"
         "    --speed-rpm 11.4 --balls \"90:39.9,63:47.3,45:12.8\" --filling 0.3",
         prepare<NewOptions, new_verb>},
    Verb{"check", "Check a case and print what would be simulated: counts, time step, cost",
         "  millwear check cases/pilot_mill/case.toml\n"
         "  millwear check cases/seed_mill_8m/case.toml --json\n"
         "  millwear check cases/seed_mill_8m_desktop/case.toml --ranks 1,2,4,8",
         prepare<CheckOptions, check_verb>},
    Verb{"mesh", "Write the liner's mesh (STL) and its section for CAD (STEP, DXF)",
         "  millwear mesh cases/pilot_mill/case.toml --out mesh\n"
         "  millwear mesh cases/pilot_mill/case.toml --profile worn.csv --out mesh",
         prepare<MeshOptions, mesh_verb>},
    Verb{"draw", "Draw the liner in its mill to scale, with particles for size (SVG, PNG)",
         "  millwear draw cases/pilot_mill/case.toml --out drawings\n"
         "  millwear draw cases/pilot_mill/case.toml --profile worn.csv --out drawings",
         prepare<DrawOptions, draw_verb>},
    Verb{"deck", "Write the mesh and the LIGGGHTS decks, to read or to run by hand",
         "  millwear deck cases/pilot_mill/case.toml --out deck\n"
         "  cd deck/cycle_000/mix && mpirun -np 2 liggghts -in deck.in",
         prepare<DeckOptions, deck_verb>},
    Verb{"run", "Simulate the liner from new to worn out; the same command resumes",
         "  millwear run cases/pilot_mill/case.toml\n"
         "  millwear run cases/pilot_mill/case.toml --out runs/try --ranks 2 --explain",
         prepare<RunOptions, run_verb>},
    Verb{"study", "Vary keys of a case, run a campaign for every point, and compare them",
         "  millwear study cases/spacing_study/study.toml --dry-run\n"
         "  millwear study cases/spacing_study/study.toml --jobs 2\n"
         "  millwear study cases/pilot_mill/case.toml --axis mill.rows=8,10,12 \\\n"
         "    --axis lifter.height_m=0.03:0.05:0.01 --objective \"maximise life_hours\"",
         prepare<StudyOptions, study_verb>},
    Verb{"status", "Say how far a campaign or a study is, also one in the queue of Slurm",
         "  millwear status cases/pilot_mill/case.toml\n"
         "  millwear status cases/spacing_study/study.toml\n"
         "  millwear status runs/pilot_mill",
         prepare<StatusOptions, status_verb>},
    Verb{"report", "Write the result files and report.html of a campaign so far",
         "  millwear report cases/pilot_mill/case.toml --out runs/try",
         prepare<ReportOptions, report_verb>},
    Verb{"export",
         "Write liner and charge for ParaView, and any step's liner as STL, STEP, DXF, CSV",
         "  millwear export cases/pilot_mill/case.toml --paraview viewer\n"
         "  millwear export cases/pilot_mill/case.toml --stl worn_out.stl --step worn_out.step\n"
         "  millwear export cases/pilot_mill/case.toml --cycle 2 --at-step 1 --csv profile.csv",
         prepare<ExportOptions, export_verb>},
    Verb{"wear", "Apply another wear law to the loads of a campaign, without new DEM",
         "  cp cases/pilot_mill/case.toml other_law.toml   # and change the laws in its [wear]\n"
         "  millwear wear other_law.toml --out runs/pilot_mill\n"
         "  millwear wear other_law.toml --out runs/pilot_mill --csv rates.csv --json",
         prepare<WearOptions, wear_verb>},
    Verb{"import", "Import a gauge reading, a scan or a drawing of the worn liner",
         "  millwear import my_mill.toml scan.csv --hours 5112 --unit mm\n"
         "  millwear import my_mill.toml drawing.dxf --hours 5448 --layer LINER --error-mm 0.5\n"
         "  millwear import my_mill.toml --hours 6312 --height-mm 56",
         prepare<ImportOptions, import_verb>},
    Verb{"compare",
         "Compare a campaign with gauge readings, two profiles, or campaigns side by side",
         "  millwear compare my_mill.toml\n"
         "  millwear compare my_mill.toml --out runs/try --csv comparison.csv\n"
         "  millwear compare my_mill.toml --calibrate-until 5112 --plot calibrated.png\n"
         "  millwear compare my_mill.toml --profiles scanned.csv predicted.csv\n"
         "  millwear compare runs/pilot_mill runs/try --page comparison.html",
         prepare<CompareOptions, compare_verb>},
    Verb{
        "calibrate", "Fit the coefficients of the wear laws to measured wear, without new DEM",
        "  millwear calibrate cases/pilot_mill/case.toml   # reads cases/pilot_mill/gauge\n"
        "  millwear calibrate two_laws.toml --out runs/pilot_mill --readings measured --until 4000",
        prepare<CalibrateOptions, calibrate_verb>},
    Verb{"tune", "Find the fastest neighbour skin and split among ranks, by a short trial",
         "  millwear tune my_mill.toml                  # takes the mixed charge in runs/NAME, if "
         "any\n"
         "  millwear tune my_mill.toml --out runs/try --ranks 2 --json",
         prepare<TuneOptions, tune_verb>},
    Verb{"postprocess", "Turn the dumps of your own LIGGGHTS run into load, worn profile and mesh",
         "  millwear postprocess my_mill.toml --contacts contacts.dump --particles particles.dump "
         "\\\n"
         "    --timestep 2e-5 --out worn\n"
         "  millwear postprocess my_mill.toml --contacts c.dump --particles p.dump --timestep 2e-5 "
         "\\\n"
         "    --profile worn.csv --mesh liner.stl --after 200000 --hours 500 --out worn_2",
         prepare<PostprocessOptions, postprocess_verb>},
};

}  // namespace

std::span<const Verb> verbs() { return table; }

}  // namespace millwear::orchestrator
