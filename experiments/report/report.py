#!/usr/bin/python3
"""The report: the study (OUT/study.csv), a campaign's tables (OUT/tables/verify_*.csv) and the experiments' CSV files in OUT
-> OUT/report.html, OUT/figures/*.{pdf,svg}, OUT/tables/*.csv.

Every number in it is computed from these rows; nothing is written by hand. Any may be missing, not all.
usage: report.py OUT
"""

import multiprocessing
import os
import pickle
import sys
import tempfile

import figures_certificates
import figures_failure
import figures_motion
import figures_need
import figures_overlap
import figures_paper
import figures_peers
import figures_scenes
import figures_signs
import figures_speed
import figures_stability
import figures_stages
import report_methods
import tables_bounds
import tables_motion
import tables_price
import tables_queries
from campaign_data import Campaign
from report_page import Page
from report_style import set_style
from study_data import Study


MODULES = (figures_speed, tables_price, figures_failure, figures_stability, figures_signs, figures_paper, figures_stages, figures_peers, tables_queries,
           figures_scenes, figures_need, tables_bounds, tables_motion, figures_motion,
           figures_overlap, figures_certificates)


def chart(page, study, campaign):
    yield figures_speed.study_chart(page, study) if study else figures_speed.campaign_chart(page, campaign)


def in_processes(tasks):
    """What each of these functions returns, by as many processes as there are processors. Forked, they have the rows already; a result's file says that it is
    taken. No thread waits for them: whatever ends one of them ends the whole."""
    with tempfile.TemporaryDirectory() as folder:
        files = [os.path.join(folder, str(number)) for number in range(len(tasks))]

        def work():
            for task, path in zip(tasks, files):
                try:
                    file = open(path, "xb")
                except FileExistsError:
                    continue
                with file:
                    pickle.dump(task(), file)

        workers = [multiprocessing.get_context("fork").Process(target=work) for _ in range(os.cpu_count())]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        for worker in workers:
            if worker.exitcode:  # its own error is told; what is killed has told nothing
                sys.exit(1 if worker.exitcode > 0 else f"a process that drew was ended by signal {-worker.exitcode}")
        results = []
        for path in files:
            with open(path, "rb") as file:
                results.append(pickle.load(file))
        return results


def page_of(page, study, campaign):
    (drawn,), *of_modules = in_processes([lambda sections=sections: list(sections(page, study, campaign))
                                          for sections in (chart, *(module.sections for module in MODULES))])
    opening = f'<p class="claim">{figures_speed.claim(study, campaign)}</p>{drawn}'
    if verdicts := figures_speed.verdicts(study, campaign):
        opening += f'<h2 id="verdicts">The verdict</h2>{verdicts}'
    if drawn:
        opening += report_methods.KEY_OF_CHART
    sections = [section for of_module in of_modules for section in of_module]
    sections += report_methods.sections(page, study, campaign)
    return report_methods.frame(opening, sections)


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: report.py OUT")
    set_style()
    out = sys.argv[1]
    study, campaign = Study(out), Campaign(out)
    if not study and not campaign:
        sys.exit(f"{os.path.join(out, 'study.csv')}: no such file; expected the results of tetracone experiment study, or of tetracone "
                 f"report DB")
    page = Page(out)
    page.write("report.html", page_of(page, study, campaign))


if __name__ == "__main__":
    main()
