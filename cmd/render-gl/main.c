/* render-gl: draws a 3D scene with strokes. */
#include "render-gl/mode/modes.h"
#include "render-gl/mode/parse_args.h"
#include "render-gl/window/window.h"
#include "shared/report.h"

/* Opens the output files before any work, so that a missing or read-only folder is reported at once. */
static void open_outputs(struct job *job)
{
    const struct options *options = job->options;
    bool report = options->timed_frames || options->probe || options->needs;
    struct hatch_err err;
    if (!report)
        cmd_check_ending(job->args.output, "png exr svg tsv");
    if (options->window)
        return;
    if (options->times_path)
        job->times_output = cmd_open_report(&job->args, options->times_path);
    uint32_t count = report ? 1 : options->frames;
    job->outputs = HATCH_NEW(&job->args.keep, struct cmd_output *, count, &err);
    cmd_check(job->outputs ? HATCH_OK : HATCH_LIMIT, NULL, &err);
    for (uint32_t frame = 0; frame < count; frame++) {
        const char *name = job->args.output ? job->args.output : "-";
        char numbered[4096];
        if (!report && options_is_given("frames")) {
            parse_frame_name(name, frame, numbered, sizeof numbered);
            name = numbered;
        }
        job->outputs[frame] = options->needs
                                  ? cmd_open_output(name, job->args.json ? "json needs txt" : "tsv needs txt", false)
                              : report ? cmd_open_report(&job->args, name)
                                       : cmd_open_output(name, "png exr svg tsv", !options->vectors);
    }
}

int main(int argc, char **argv)
{
    static struct job job;
    job.options = options_read(argc, argv, &job.args);
    params_read(job.options);
    job.open_window = job.options->window ? window_open : NULL;
    open_outputs(&job);
    job_read(&job);
    needs_check_mode(&job);
    if (job.options->vectors && !job.options->technique->curves) {
        job_prepare_without_gpu(&job);
        vectors_write(&job);
        return cmd_end(&job.args, HATCH_OK);
    }
    job_prepare(&job);
    needs_check(&job);
    if (job.options->vectors)
        vectors_write(&job);
    else if (job.options->window)
        window_run(&job);
    else if (job.options->timed_frames)
        timing_report(&job);
    else if (job.options->probe)
        probe_report(&job);
    else if (job.options->needs)
        needs_report(&job);
    else
        pictures_write(&job);
    job_end(&job);
    return cmd_end(&job.args, HATCH_OK);
}
