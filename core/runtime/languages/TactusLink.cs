// The live link for .NET, Mono and Unity: models while they are edited in Tactus, forces at points, and where your simulator
// is. Put it beside Tactus.cs. The protocol: docs/live-link.md.
//
//   using (var link = new Tactus.Link(port, token, "my simulator"))
//   {
//       link.Felt(timeS, feel.DepthMm + model.Renderer.DepthOffsetMm, feel.SpeedMmS, feel.ForceN, conditions);   // e.g. each frame
//       string text; int serial;
//       if (link.TakeModel(out text, out serial)) { model = Tactus.Model.Read(text); ... tube.Scene(model.Scene(conditions)); }
//   }
//
// A thread of its own reads; no call but the constructor waits for the server, and TakeModel always gives the newest.
using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Net;
using System.Net.Sockets;
using System.Text;
using System.Threading;

namespace Tactus
{
    /// A connection. Felt and TakeModel may be called from any thread.
    public sealed class Link : IDisposable
    {
        private const int HelloMs = 5000;

        private readonly TcpClient client_;
        private readonly StreamReader lines_;
        private readonly Stream out_;
        private readonly Thread thread_;
        private readonly object mutex_ = new object();  // guards the next five
        private string model_;
        private int serial_;
        private string error_;
        private bool ended_;
        private byte[] waiting_;  // the newest Felt that was not sent yet
        private readonly AutoResetEvent toSend_ = new AutoResetEvent(false);
        private readonly Thread sender_;

        /// What the server is: `tactus 0.2.0`.
        public readonly string Program;

        /// Connects to the loopback; on another computer forward the port with ssh. `token`: the first line of the token
        /// file. Throws Error where the server refuses, and SocketException where there is none.
        public Link(int port, string token, string name)
        {
            client_ = new TcpClient();
            try
            {
                client_.Connect(IPAddress.Loopback, port);
                client_.NoDelay = true;
                out_ = client_.GetStream();
                lines_ = new StreamReader(out_, new UTF8Encoding(false));
                Write(Encoding.UTF8.GetBytes("{\"hello\":\"tactus-link\",\"version\":1,\"token\":" + Json(token) +
                                             ",\"want\":[\"model\"],\"name\":" + Json(name) + "}\n"));
                client_.ReceiveTimeout = HelloMs;
                string hello = lines_.ReadLine() ?? "";
                client_.ReceiveTimeout = 0;
                if (hello.StartsWith("{\"error\":")) throw new Error(Status.BadArgument, Text(hello, "\"error\":"));
                if (!hello.StartsWith("{\"hello\":\"tactus-link\""))
                    throw new Error(Status.BadArgument, "found another program there, wanted a Tactus that serves");
                Program = Text(hello, "\"program\":");
            }
            catch (IOException)
            {
                client_.Close();
                throw new Error(Status.BadArgument, "found no answer in time, wanted a Tactus that serves");
            }
            catch
            {
                client_.Close();
                throw;
            }
            thread_ = new Thread(Read) { IsBackground = true };
            thread_.Start();
            sender_ = new Thread(Send) { IsBackground = true };
            sender_.Start();
        }

        /// The sentence with which the server ended the connection, or null.
        public string ErrorSentence { get { lock (mutex_) return error_; } }

        /// Whether the connection has ended.
        public bool Ended { get { lock (mutex_) return ended_; } }

        /// The newest model that was not taken yet, for Model.Read; false: there is none.
        public bool TakeModel(out string text, out int serial)
        {
            lock (mutex_)
            {
                text = model_;
                serial = serial_;
                model_ = null;
            }
            return text != null;
        }

        /// Where this simulator is; depth as the model counts it. `conditions` may be null. Does not wait: one that was not
        /// sent yet is replaced. Numbers must be finite.
        public void Felt(double timeS, double depthMm, double speedMmS, double forceN, IDictionary<string, double> conditions)
        {
            var line = new StringBuilder("{\"felt\":{\"time_s\":");
            line.Append(Number(timeS)).Append(",\"depth_mm\":").Append(Number(depthMm));
            line.Append(",\"speed_mm_s\":").Append(Number(speedMmS)).Append(",\"force_n\":").Append(Number(forceN));
            line.Append(",\"conditions\":{");
            string separator = "";
            if (conditions != null)
            {
                foreach (KeyValuePair<string, double> one in conditions)
                {
                    line.Append(separator).Append(Json(one.Key)).Append(':').Append(Number(one.Value));
                    separator = ",";
                }
            }
            byte[] bytes = Encoding.UTF8.GetBytes(line.Append("}}}\n").ToString());
            lock (mutex_) waiting_ = bytes;
            toSend_.Set();
        }

        public void Dispose()
        {
            lock (mutex_) ended_ = true;
            client_.Close();
            toSend_.Set();
            thread_.Join();
            sender_.Join();
        }

        private void Read()
        {
            const string model = "{\"model\":{\"serial\":", file = "\"file\":";
            try
            {
                for (string line = lines_.ReadLine(); line != null; line = lines_.ReadLine())
                {
                    if (line.StartsWith("{\"error\":", StringComparison.Ordinal))
                    {
                        lock (mutex_) error_ = Text(line, "\"error\":");
                    }
                    int begin = line.IndexOf(file, StringComparison.Ordinal);
                    if (!line.StartsWith(model, StringComparison.Ordinal) || begin < 0) continue;
                    // The server promises that `file` is the last member.
                    begin += file.Length;
                    int digits = model.Length;
                    while (char.IsDigit(line[digits])) ++digits;
                    lock (mutex_)
                    {
                        model_ = line.Substring(begin, line.Length - begin - 2);
                        serial_ = int.Parse(line.Substring(model.Length, digits - model.Length), CultureInfo.InvariantCulture);
                    }
                }
            }
            catch (IOException) {}
            catch (ObjectDisposedException) {}
            lock (mutex_) ended_ = true;
            toSend_.Set();
        }

        private void Send()
        {
            while (true)
            {
                toSend_.WaitOne();
                byte[] bytes;
                lock (mutex_)
                {
                    if (ended_) return;
                    bytes = waiting_;
                    waiting_ = null;
                }
                if (bytes == null) continue;
                try
                {
                    Write(bytes);
                }
                catch (IOException) { return; }
                catch (ObjectDisposedException) { return; }
            }
        }

        private void Write(byte[] bytes) { out_.Write(bytes, 0, bytes.Length); }

        private static string Number(double value)
        {
            if (double.IsNaN(value) || double.IsInfinity(value))
                throw new Error(Status.BadArgument, "felt: found a number that is not finite, wanted finite ones");
            return value.ToString("R", CultureInfo.InvariantCulture);
        }

        private static string Json(string text)
        {
            var json = new StringBuilder("\"");
            foreach (char c in text)
            {
                if (c == '"' || c == '\\') json.Append('\\').Append(c);
                else if (c < ' ') json.Append("\\u").Append(((int)c).ToString("x4"));
                else json.Append(c);
            }
            return json.Append('"').ToString();
        }

        /// The text that follows `key` in a line of the server.
        private static string Text(string line, string key)
        {
            int at = line.IndexOf(key, StringComparison.Ordinal) + key.Length + 1;
            var text = new StringBuilder();
            for (; at < line.Length && line[at] != '"'; ++at)
            {
                if (line[at] == '\\' && at + 1 < line.Length) ++at;
                text.Append(line[at]);
            }
            return text.ToString();
        }
    }
}
