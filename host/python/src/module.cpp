// What Python calls: lxs/_lxs.pyi declares it, lxs/__init__.py is what users see.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <mutex>
#include <utility>

#include "lxs/host/catalogue.h"
#include "lxs/host/failure.h"
#include "lxs/images/image_library.h"
#include "render.h"

namespace py = pybind11;

namespace lxs {
namespace {

/// Messages until Python takes them: threads that render have nothing to do with it.
class Messages {
  public:
    void take(MessageKind kind, std::string_view text) {
        const std::lock_guard lock(mutex_);
        texts_.emplace_back(kind, text);
    }
    /// Hands them to Python's logging; with the GIL.
    void tell() {
        std::vector<std::pair<MessageKind, std::string>> texts;
        {
            const std::lock_guard lock(mutex_);
            texts.swap(texts_);
        }
        if (texts.empty()) return;
        const py::module_ logging = py::module_::import("logging");
        const py::object log = logging.attr("getLogger")("lxs").attr("log");
        for (const auto& [kind, text] : texts)
            log(logging.attr(level(kind)), "%s", text);
    }

  private:
    static const char* level(MessageKind kind) {
        switch (kind) {
            case MessageKind::Debug:
                return "DEBUG";
            case MessageKind::Info:
                return "INFO";
            case MessageKind::Verbatim:  // what a scene is warned of
            case MessageKind::Warning:
                return "WARNING";
            case MessageKind::VerbatimError:
            case MessageKind::Error:
                break;
        }
        return "ERROR";
    }

    std::mutex mutex_;
    std::vector<std::pair<MessageKind, std::string>> texts_;
};

/// Names of files and layers may hold any bytes: os.fsencode() gives them back.
py::str text_of(const std::string& bytes) {
    return py::reinterpret_steal<py::str>(
        PyUnicode_DecodeFSDefaultAndSize(bytes.data(), static_cast<Py_ssize_t>(bytes.size())));
}

/// An array that shows values of `owner`, which lives as long as it does; for reading alone.
template <class T>
py::array view(const T* values, std::vector<py::ssize_t> shape, const py::object& owner) {
    py::array_t<T> array(std::move(shape), values, owner);
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

py::array color_view(const std::vector<Rgb>& values, std::uint32_t width, std::uint32_t height,
                     const py::object& owner) {
    static_assert(sizeof(Rgb) == 3 * sizeof(float));
    return view(&values.data()->x, {height, width, 3}, owner);
}

/// The layers beside the image. Those of one channel are named as the EXR names the channel where
/// several have the name of the layer, or none.
py::dict layer_views(const py::object& self) {
    const auto& layers = self.cast<const RenderedImage&>().layers;
    const FilmFrame& frame = layers.frame;
    py::dict views;
    for (std::size_t i = 1; i < layers.colors.size(); ++i) {
        const ColorLayer& layer = layers.colors[i];
        views[text_of(layer.name)] = color_view(layer.values, frame.width, frame.height, self);
    }
    const auto of_name = [&](const std::string& name) {
        return std::count_if(layers.floats.begin(), layers.floats.end(),
                             [&](const FloatLayer& layer) { return layer.name == name; });
    };
    for (const FloatLayer& layer : layers.floats) {
        std::string name = layer.name;
        if (name.empty()) {
            name = layer.channel;
        } else if (of_name(layer.name) > 1) {
            name += std::string(".") + layer.channel;
        }
        views[text_of(name)] = view(layer.values.data(), {frame.height, frame.width}, self);
    }
    return views;
}

/// A render whose messages Python gets.
class PythonRender {
  public:
    explicit PythonRender(CommandLine command) {
        telling([&] {
            render_ = std::make_unique<Render>(
                std::move(command),
                [this](MessageKind kind, std::string_view text) { messages_.take(kind, text); });
        });
    }

    /// `on_pass`: None, or called with the figures of lxs.Progress at most once in `interval`
    /// seconds, and at the end; False ends the render. So does what it or a signal raises, which is
    /// raised once the pass is done. False as Render::run().
    bool run(const Ending& ending, const py::object& on_pass, double interval) {
        std::exception_ptr raised;
        RenderTotals told = render_->totals();
        double due = 0;
        bool could = false;
        const auto tell = [&](const RenderTotals& totals) {
            told = totals;
            due = totals.seconds + interval;
            const std::optional<double> error = render_->error();
            const py::gil_scoped_acquire gil;
            const py::object said = on_pass(totals.passes, totals.seconds, totals.photon_paths,
                                            totals.rays, totals.samples_per_pixel, error);
            return !said.is(py::bool_(false));
        };
        telling([&] {
            could = render_->run(ending, [&](const RenderTotals& totals) {
                try {
                    heed_signals();
                    return on_pass.is_none() || totals.seconds < due || tell(totals);
                } catch (py::error_already_set&) {
                    raised = std::current_exception();
                    return false;
                }
            });
        });
        if (raised) std::rethrow_exception(raised);
        const RenderTotals last = render_->totals();
        if (!on_pass.is_none() && last.passes > told.passes) tell(last);
        return could;
    }
    py::array image() {
        auto pixels = std::make_unique<std::vector<Rgb>>();
        telling([&] { *pixels = render_->image(); });
        const py::capsule owner(pixels.get(),
                                [](void* held) { delete static_cast<std::vector<Rgb>*>(held); });
        return color_view(*pixels.release(), render_->width(), render_->height(), owner);
    }
    std::shared_ptr<RenderedImage> result() {
        auto result = std::make_shared<RenderedImage>();
        telling([&] { *result = render_->result(); });
        return result;
    }
    std::uint64_t passes() const {
        const py::gil_scoped_release released;
        return render_->totals().passes;
    }

  private:
    /// Does `work` without the GIL; its messages are told then, also where it fails.
    void telling(const auto& work) {
        std::exception_ptr failure;
        {
            const py::gil_scoped_release released;
            try {
                work();
            } catch (...) {
                failure = std::current_exception();
            }
        }
        messages_.tell();
        if (failure) std::rethrow_exception(failure);
    }
    void heed_signals() {
        const py::gil_scoped_acquire gil;
        messages_.tell();
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }

    Messages messages_;
    std::unique_ptr<Render> render_;
};

/// Raises lxs.`name`, which the package defines.
void raise(const char* name, const py::tuple& arguments) {
    const py::object type = py::module_::import("lxs").attr(name);
    PyErr_SetObject(type.ptr(), type(*arguments).ptr());
}

py::object none_if_zero(std::uint32_t number) {
    return number == 0 ? py::object(py::none()) : py::object(py::int_(number));
}

void translate(std::exception_ptr thrown) {
    try {
        std::rethrow_exception(std::move(thrown));
    } catch (const Refusal& refusal) {
        const py::object file =
            refusal.file.empty() ? py::object(py::none()) : py::object(text_of(refusal.file));
        raise("InputError",
              py::make_tuple(text_of(refusal.what()), text_of(refusal.message), file,
                             none_if_zero(refusal.line), none_if_zero(refusal.column)));
    } catch (const PluginFailure& failure) {
        raise("PluginError", py::make_tuple(text_of(failure.what())));
    } catch (const ImageLibraryFailure& failure) {
        raise("PluginError", py::make_tuple(text_of(failure.what())));
    } catch (const OutputFailure& failure) {
        PyErr_SetObject(PyExc_OSError, text_of(failure.what()).ptr());
    }
}

void save(const RenderedImage& image, const std::string& path) {
    const py::gil_scoped_release released;
    try {
        write_exr(path, image.layers);
    } catch (const std::runtime_error& error) {
        throw OutputFailure(error.what());
    }
}

std::string describe(const std::string& name, const std::vector<std::string>& plugin_paths) {
    PluginLibrary plugins;
    load_plugins(plugin_paths, plugins);
    return describe_plugin(name, plugins, false);
}

std::vector<std::string> integrators(const std::vector<std::string>& plugin_paths) {
    PluginLibrary plugins;
    load_plugins(plugin_paths, plugins);
    return plugins.names();
}

}  // namespace

PYBIND11_MODULE(_lxs, module) {
    py::register_local_exception_translator(&translate);
    module.def("version", &version);
    module.def("describe", &describe);
    module.def("integrators", &integrators);

    py::class_<RenderedImage, std::shared_ptr<RenderedImage>>(module, "Image")
        .def_property_readonly("passes", [](const RenderedImage& i) { return i.totals.passes; })
        .def_property_readonly("seconds", [](const RenderedImage& i) { return i.totals.seconds; })
        .def_readonly("error", &RenderedImage::error)
        .def_readonly("stopped", &RenderedImage::stopped)
        .def_readonly("statistics", &RenderedImage::statistics)
        .def_property_readonly("image",
                               [](const py::object& self) {
                                   const auto& layers = self.cast<const RenderedImage&>().layers;
                                   return color_view(layers.colors.front().values,
                                                     layers.frame.width, layers.frame.height, self);
                               })
        .def_property_readonly(
            "display",
            [](const py::object& self) {
                const auto& image = self.cast<const RenderedImage&>();
                const FilmFrame& frame = image.layers.frame;
                return view(image.shown.data(), {frame.height, frame.width, 3}, self);
            })
        .def_property_readonly("layers", &layer_views)
        .def("save", &save);

    py::class_<PythonRender>(module, "Render")
        .def(py::init([](const py::kwargs& given) {
            CommandLine command;
            const auto take = [&given](const char* name, auto& value) {
                value = given[name].cast<std::decay_t<decltype(value)>>();
            };
            take("scene", command.scene);
            take("integrator", command.integrator);
            take("sampler", command.sampler);
            take("overrides", command.overrides);
            take("seed", command.seed);
            take("threads", command.threads);
            take("width", command.width);
            take("height", command.height);
            take("layers", command.layers);
            take("error_estimate", command.error_estimate);
            take("strict", command.strict);
            take("plugin_paths", command.plugin_paths);
            if (given["denoise"].cast<bool>()) command.denoise = Denoising::All;
            return std::make_unique<PythonRender>(std::move(command));
        }))
        .def("run",
             [](PythonRender& render, std::optional<std::uint64_t> passes,
                std::optional<double> seconds, std::optional<double> error,
                const py::object& on_pass, double interval) {
                 return render.run({passes, seconds, error}, on_pass, interval);
             })
        .def("image", &PythonRender::image)
        .def("result", &PythonRender::result)
        .def("passes", &PythonRender::passes);
}

}  // namespace lxs
