/* Which of EGL's devices are opened, and what is asked of a driver. Functions that tell about devices and drivers are
 * replaced; those that open a context are the driver's. */
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <stdlib.h>
#include <string.h>

#include "render-gl/gpu/context.h"
#include "run.h"

enum { LISTED_MAX = 20 };

static PFNEGLQUERYDEVICESEXTPROC query_devices;
static PFNEGLQUERYDEVICESTRINGEXTPROC query_string;
static PFNEGLGETPLATFORMDISPLAYEXTPROC get_display;
static EGLint listed;    /* devices that the driver lists */
static EGLint hardware;  /* index of the first device that is no software renderer */
static EGLint opened;    /* index of the device whose display was asked for last; -1: none */
static bool surfaceless; /* the display without a device was asked for */

/* A software renderer, or the driver's first device, stands for all that are listed, under numbers of their own. */
static EGLDeviceEXT real_device;
static char names[LISTED_MAX];

static bool find_real_device(void)
{
    EGLDeviceEXT devices[LISTED_MAX];
    EGLint count = 0;
    epoxy_eglQueryDevicesEXT = query_devices;
    epoxy_eglQueryDeviceStringEXT = query_string;
    if (!eglQueryDevicesEXT(LISTED_MAX, devices, &count) || count == 0)
        return false;
    real_device = devices[0];
    for (EGLint i = 0; i < count; i++) {
        const char *kind = eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS);
        if (kind && strstr(kind, "EGL_MESA_device_software"))
            real_device = devices[i];
    }
    return true;
}

static EGLint number_of(EGLDeviceEXT device)
{
    return (EGLint)((char *)device - names);
}

static const char *describe(EGLDeviceEXT device, EGLint name)
{
    ck_assert_int_eq(name, EGL_EXTENSIONS);
    return number_of(device) < hardware ? "EGL_MESA_device_software EGL_EXT_device_name" : "EGL_EXT_device_name";
}

static EGLBoolean list(EGLint most, EGLDeviceEXT *devices, EGLint *count)
{
    bool found = find_real_device();
    epoxy_eglQueryDeviceStringEXT = describe;
    *count = most < listed ? most : listed;
    for (EGLint i = 0; i < *count; i++)
        devices[i] = &names[i];
    return found;
}

static EGLDisplay display_of(EGLenum platform, void *native, const EGLint *attributes)
{
    surfaceless = surfaceless || platform == EGL_PLATFORM_SURFACELESS_MESA;
    if (platform == EGL_PLATFORM_DEVICE_EXT) {
        opened = number_of(native);
        native = real_device;
    }
    epoxy_eglGetPlatformDisplayEXT = get_display;
    EGLDisplay display = eglGetPlatformDisplayEXT(platform, native, attributes);
    get_display = epoxy_eglGetPlatformDisplayEXT;
    epoxy_eglGetPlatformDisplayEXT = display_of;
    return display;
}

static void begin(void)
{
    query_devices = epoxy_eglQueryDevicesEXT;
    query_string = epoxy_eglQueryDeviceStringEXT;
    get_display = epoxy_eglGetPlatformDisplayEXT;
    epoxy_eglQueryDevicesEXT = list;
    epoxy_eglGetPlatformDisplayEXT = display_of;
    opened = -1;
}

static void open_context(EGLint devices, EGLint first_hardware)
{
    struct gpu_context context = {0};
    struct hatch_err err;
    listed = devices;
    hardware = first_hardware;
    HATCH_TEST_OK(gpu_context_open_headless(&context, 1, &err), &err);
    ck_assert_ptr_eq(eglGetCurrentContext(), context.handle);
    gpu_context_close(&context);
    ck_assert_ptr_eq(eglGetCurrentContext(), EGL_NO_CONTEXT);
}

START_TEST(the_first_hardware_device_is_opened)
{
    open_context(5, 2);
    ck_assert_int_eq(opened, 2);
    ck_assert(!surfaceless);
}
END_TEST

START_TEST(software_devices_are_not_opened)
{
    open_context(3, 3);
    ck_assert_int_eq(opened, -1);
    ck_assert(surfaceless);
}
END_TEST

START_TEST(no_device_is_needed)
{
    open_context(0, 0);
    ck_assert_int_eq(opened, -1);
    ck_assert(surfaceless);
}
END_TEST

static PFNEGLQUERYSTRINGPROC query_client;
static const char *client_extensions;

static const char *client_string(EGLDisplay display, EGLint name)
{
    if (display == EGL_NO_DISPLAY && name == EGL_EXTENSIONS)
        return client_extensions;
    epoxy_eglQueryString = query_client;
    const char *text = eglQueryString(display, name);
    query_client = epoxy_eglQueryString;
    epoxy_eglQueryString = client_string;
    return text;
}

/* EGL_EXT_device_base is the older form of the two others. NVIDIA's drivers name it alone. */
START_TEST(drivers_may_list_devices_by_either_extension)
{
    static const char *const named[2] = {
        "EGL_EXT_platform_base EGL_EXT_platform_device EGL_EXT_device_base",
        "EGL_EXT_platform_base EGL_EXT_platform_device EGL_EXT_device_enumeration EGL_EXT_device_query"};
    client_extensions = named[_i];
    query_client = epoxy_eglQueryString;
    epoxy_eglQueryString = client_string;
    open_context(5, 2);
    ck_assert_int_eq(opened, 2);
}
END_TEST

/* A user may ask EGL for its messages; of Mesa's threads there are as many as the command has. */
START_TEST(only_the_number_of_threads_replaces_a_variable)
{
    setenv("LP_NUM_THREADS", "7", 1);
    unsetenv("EGL_LOG_LEVEL");
    open_context(1, 1);
    ck_assert_str_eq(getenv("EGL_LOG_LEVEL"), "fatal");
    ck_assert_str_eq(getenv("LP_NUM_THREADS"), "1");
    setenv("EGL_LOG_LEVEL", "warning", 1);
    open_context(1, 1);
    ck_assert_str_eq(getenv("EGL_LOG_LEVEL"), "warning");
}
END_TEST

START_TEST(sixteen_devices_are_looked_at)
{
    open_context(LISTED_MAX, _i);
    ck_assert_int_eq(opened, _i < 16 ? _i : -1);
    ck_assert(surfaceless == (_i >= 16));
}
END_TEST

/* A driver without a context, whose functions return what a test sets. They replace those of libepoxy. */
static struct {
    int version;
    const char *extension;
    GLint texture_px, viewport_px[2];
} driver = {.version = 45, .extension = ""};

int epoxy_gl_version(void)
{
    return driver.version;
}

bool epoxy_has_gl_extension(const char *extension)
{
    return strcmp(extension, driver.extension) == 0;
}

static void get_integers(GLenum name, GLint *values)
{
    if (name == GL_MAX_TEXTURE_SIZE)
        values[0] = driver.texture_px;
    if (name == GL_MAX_VIEWPORT_DIMS)
        memcpy(values, driver.viewport_px, sizeof driver.viewport_px);
}

static void get_floats(GLenum name, GLfloat *values)
{
    if (name == GL_MAX_TEXTURE_MAX_ANISOTROPY)
        values[0] = 7;
}

static const GLubyte *get_string(GLenum name)
{
    (void)name;
    return (const GLubyte *)"a device";
}

static void ignore(GLenum name, GLint value)
{
    (void)name;
    (void)value;
}

static enum hatch_status read_limits(struct gpu_context *context, struct hatch_err *err)
{
    epoxy_glGetIntegerv = get_integers;
    epoxy_glGetFloatv = get_floats;
    epoxy_glGetString = get_string;
    epoxy_glPixelStorei = ignore;
    return gpu_context_read_limits(context, err);
}

START_TEST(opengl_before_4_5_is_refused)
{
    struct gpu_context context = {0};
    struct hatch_err err;
    driver.version = 45;
    HATCH_TEST_OK(read_limits(&context, &err), &err);
    driver.version = 44;
    ck_assert_int_eq(read_limits(&context, &err), HATCH_IO);
    ck_assert_str_eq(err.text, "the driver has OpenGL 4.4, OpenGL 4.5 is needed");
    driver.version = 30;
    ck_assert_int_eq(read_limits(&context, &err), HATCH_IO);
    ck_assert_str_eq(err.text, "the driver has OpenGL 3.0, OpenGL 4.5 is needed");
}
END_TEST

START_TEST(pictures_keep_to_the_least_of_the_limits)
{
    static const GLint sides[3][3] = {{16384, 32768, 32768}, {32768, 16384, 32768}, {32768, 32768, 16384}};
    for (int i = 0; i < 3; i++) {
        struct gpu_context context = {0};
        struct hatch_err err;
        driver.texture_px = sides[i][0];
        driver.viewport_px[0] = sides[i][1];
        driver.viewport_px[1] = sides[i][2];
        HATCH_TEST_OK(read_limits(&context, &err), &err);
        ck_assert_uint_eq(context.size_max_px, 16384);
    }
}
END_TEST

START_TEST(either_extension_means_anisotropic_filters)
{
    static const char *const names_of[3] = {"GL_ARB_texture_filter_anisotropic", "GL_EXT_texture_filter_anisotropic",
                                            ""};
    for (int i = 0; i < 3; i++) {
        struct gpu_context context = {0};
        struct hatch_err err;
        driver.extension = names_of[i];
        HATCH_TEST_OK(read_limits(&context, &err), &err);
        ck_assert_float_eq(context.anisotropy_max, i < 2 ? 7 : 1);
    }
}
END_TEST

static Suite *suite(void)
{
    Suite *suite = suite_create("render context");
    TCase *tests = tcase_create("context");
    tcase_add_checked_fixture(tests, begin, NULL);
    tcase_add_test(tests, the_first_hardware_device_is_opened);
    tcase_add_test(tests, software_devices_are_not_opened);
    tcase_add_test(tests, no_device_is_needed);
    tcase_add_loop_test(tests, sixteen_devices_are_looked_at, 15, 17);
    tcase_add_loop_test(tests, drivers_may_list_devices_by_either_extension, 0, 2);
    tcase_add_test(tests, only_the_number_of_threads_replaces_a_variable);
    tcase_add_test(tests, opengl_before_4_5_is_refused);
    tcase_add_test(tests, pictures_keep_to_the_least_of_the_limits);
    tcase_add_test(tests, either_extension_means_anisotropic_filters);
    suite_add_tcase(suite, tests);
    return suite;
}
HATCH_TEST_MAIN(suite)
